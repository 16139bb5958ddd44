#include "core/bake/area_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace nacre {
namespace {

// Directions between nodes: three a cell up to this many, then a third as many as there are cells, strewn
// evenly.
constexpr int between_most = 768;

// Samples whose neighbours are looked at.
constexpr std::size_t worst_looked_at = 12;

// Beyond those between nodes.
constexpr int grazing_samples = 96;

}  // namespace

AreaTable::AreaTable(std::shared_ptr<const FacetDistribution> distribution,
                     const DistributionSymmetry& symmetry, const TableSize& nodes, bool without_moment,
                     Workers& workers)
    : distribution_(std::move(distribution)),
      nodes_(nodes),
      grid_(std::make_shared<const StretchedGrid>(*distribution_, symmetry, nodes.psi, without_moment)) {
    sample_nodes_and_between(workers);
    fill();
    sample_near_worst(workers);
}

AreaTable::AreaTable(const AreaTable& before, std::shared_ptr<const FacetDistribution> distribution,
                     const std::vector<std::vector<Facet>>& changes, Workers& workers)
    : distribution_(std::move(distribution)),
      nodes_(before.nodes_),
      grid_(before.grid_),
      samples_(before.samples_),
      areas_(before.areas_) {
    const std::size_t lobes = changes.size();
    for (std::size_t l = 0; l < lobes; ++l) {
        if (changes[l].empty()) continue;
        const FacetChanges added(changes[l]);
        const glm::dmat3 to_lobe = glm::transpose(distribution_->lobes()[l].frame);
        workers.for_each(static_cast<int>(samples_->size()), [&](int i) {
            const std::size_t at = static_cast<std::size_t>(i);
            double& area = areas_[at * lobes + l];
            area = std::max(area + added.projected_area(to_lobe * (*samples_)[at].k), 0.0);
        });
    }
    fill();
}

void AreaTable::sample_nodes_and_between(Workers& workers) {
    std::vector<Sample> samples;
    for (int row = 0; row < nodes_.psi; ++row)
        for (int column = 0; column < nodes_.w; ++column)
            samples.push_back(sample_at(column, row, Place::node));
    const int cells = columns() * rows();
    if (nodes_.psi == 1) {
        for (int cell = 0; cell < cells; ++cell) samples.push_back(between(cell, Place::along_w));
    } else if (3 * cells <= between_most) {
        for (int cell = 0; cell < cells; ++cell)
            for (const Place place : kinds_between) samples.push_back(between(cell, place));
    } else {
        for (int i = 0; i < std::max(between_most, cells / 3); ++i)
            samples.push_back(between(strewn_cell(i, columns(), rows()), kinds_between[i % 3]));
    }
    // A layer at grazing may be thinner than the last cell.
    for (int i = 0; i < grazing_samples; ++i)
        samples.push_back(sample_at(
            columns() - std::exp2(-2 - i % 12),
            nodes_.psi == 1 ? 0 : rows() * std::fmod((i + 0.5) * std::numbers::phi, 1.0), Place::centre));
    add_samples(std::move(samples), workers);
}

// The strewn directions may miss the worst, which sits in few cells where p has a narrow feature: the
// neighbours of those that err most are looked at too.
void AreaTable::sample_near_worst(Workers& workers) {
    if (nodes_.psi == 1 || 3 * columns() * rows() <= between_most) return;
    const Shading<double> shading = this->shading({});
    std::vector<std::pair<double, std::size_t>> errors;
    for (std::size_t i = node_count(); i < samples_->size(); ++i)
        errors.push_back({area_error(shading, (*samples_)[i].k, area_at(i)), i});
    const std::size_t kept = std::min(errors.size(), worst_looked_at);
    std::partial_sort(errors.begin(), errors.begin() + static_cast<long>(kept), errors.end(),
                      [](const auto& a, const auto& b) {
                          return a.first != b.first ? a.first > b.first : a.second < b.second;
                      });
    std::set<int> cells;
    const bool closed = rows() == nodes_.psi;
    for (std::size_t i = 0; i < kept; ++i) {
        const Sample& worst = (*samples_)[errors[i].second];
        for (int down = -1; down <= 1; ++down)
            for (int across = -1; across <= 1; ++across) {
                const int column = static_cast<int>(worst.column) + across;
                int row = static_cast<int>(worst.row) + down;
                if (closed) row = (row + rows()) % rows();
                if (column >= 0 && column < columns() && row >= 0 && row < rows())
                    cells.insert(row * columns() + column);
            }
    }
    std::vector<Sample> samples;
    for (const int cell : cells)
        for (const Place place : kinds_between) samples.push_back(between(cell, place));
    add_samples(std::move(samples), workers);
}

// The table closes on its first row where p has no symmetry.
int AreaTable::rows() const {
    if (nodes_.psi == 1) return 1;
    return grid_->shape().symmetry == Shading<double>::SYMMETRY_NONE ? nodes_.psi : nodes_.psi - 1;
}

std::size_t AreaTable::node_count() const {
    return static_cast<std::size_t>(nodes_.psi) * static_cast<std::size_t>(nodes_.w);
}

AreaTable::Sample AreaTable::sample_at(double column, double row, Place place) const {
    return {grid_->area_direction(column / columns(), row), column, row, place};
}

AreaTable::Sample AreaTable::between(int cell, Place place) const {
    return sample_at(cell % columns() + (place == Place::along_psi ? 1 : 0.5),
                     cell / columns() + (place == Place::along_w ? 0 : 0.5), place);
}

void AreaTable::add_samples(std::vector<Sample> added, Workers& workers) {
    const std::size_t first = areas_.size() / distribution_->lobes().size();
    auto all = std::make_shared<std::vector<Sample>>();
    if (samples_) *all = *samples_;
    all->insert(all->end(), added.begin(), added.end());
    samples_ = std::move(all);
    areas_.resize(samples_->size() * distribution_->lobes().size());
    workers.for_each(static_cast<int>(added.size()),
                     [&](int i) { sample(first + static_cast<std::size_t>(i)); });
}

void AreaTable::sample(std::size_t index) {
    const std::vector<PlacedLobe>& lobes = distribution_->lobes();
    for (std::size_t l = 0; l < lobes.size(); ++l)
        areas_[index * lobes.size() + l] =
            lobes[l].lobe->projected_area(glm::transpose(lobes[l].frame) * (*samples_)[index].k);
}

double AreaTable::area_at(std::size_t index) const {
    const std::vector<PlacedLobe>& lobes = distribution_->lobes();
    double sum = 0;
    for (std::size_t l = 0; l < lobes.size(); ++l) sum += lobes[l].scale * areas_[index * lobes.size() + l];
    return sum;
}

void AreaTable::fill() {
    data_.clear();
    for (std::size_t i = 0; i < node_count(); ++i)
        data_.push_back(static_cast<float>(grid_->shape_value((*samples_)[i].k, area_at(i))));
}

Shading<double> AreaTable::shading(const Shading<double>& material) const {
    Shading<double> result = material;
    auto& shape = result.surface.tables;
    shape = grid_->shape();
    shape.nodes_w = nodes_.w;
    shape.area_offset = 0;
    result.data = data_.data();
    return result;
}

AxisError AreaTable::measure(const Shading<double>& material) const {
    const Shading<double> shading = this->shading(material);
    AxisError error;
    std::vector<double> errors;
    for (std::size_t i = node_count(); i < samples_->size(); ++i) {
        const Sample& sample = (*samples_)[i];
        errors.push_back(area_error(shading, sample.k, area_at(i)));
        if (sample.place == Place::along_w) error.polar = worse_error(error.polar, errors.back());
        if (sample.place == Place::along_psi) error.azimuth = worse_error(error.azimuth, errors.back());
    }
    error.all = summarise(errors);
    return error;
}

}  // namespace nacre
