#include "core/bake/area_table.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/bake/worst_search.h"

namespace nacre {
namespace {

// Directions between nodes: three a cell up to this many, then as many as there are cells, scattered evenly;
// for a draft exactly this many.
constexpr int final_between = 768, draft_between = 192;

// Samples whose neighbours are looked at.
constexpr std::size_t worst_looked_at = 24;

// Beyond those between nodes.
constexpr int grazing_samples = 96;

// A search looks into one of `cells_each` cells, at least `cells_min`, and climbs from `climbs` points.
// A thorough one looks into every cell.
constexpr int cells_each = 24, cells_min = 8, climbs = 6, thorough_climbs = 32;

}  // namespace

AreaTable::AreaTable(std::shared_ptr<const FacetDistribution> distribution,
                     const DistributionSymmetry& symmetry, TableNodes nodes, bool without_moment,
                     Quality quality, Workers& workers)
    : distribution_(std::move(distribution)),
      nodes_(nodes),
      quality_(quality),
      grid_(std::make_shared<const StretchedGrid>(*distribution_, symmetry, nodes.azimuth, without_moment)) {
    sample_nodes_and_between(workers);
    fill();
    sample_near_worst(workers);
}

AreaTable::AreaTable(const AreaTable& before, std::shared_ptr<const FacetDistribution> distribution,
                     const std::vector<std::vector<Facet>>& changes, Workers& workers)
    : distribution_(std::move(distribution)),
      nodes_(before.nodes_),
      quality_(before.quality_),
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
    for (int row = 0; row < nodes_.azimuth; ++row)
        for (int column = 0; column < nodes_.polar; ++column)
            samples.push_back(
                sample_at({static_cast<double>(column), static_cast<double>(row), TablePlace::node}));
    const TableCells cells = this->cells();
    for (const TablePoint& point :
         all_measured() ? cells.every_place() : cells.scattered(strewn_directions()))
        samples.push_back(sample_at(point));
    for (const TablePoint& point : cells.grazing(grazing_samples)) samples.push_back(sample_at(point));
    add_samples(std::move(samples), workers);
}

// The scattered directions may miss the worst error, which is in few cells where p has a narrow feature:
// the neighbours of those with the largest errors are measured too.
void AreaTable::sample_near_worst(Workers& workers) {
    if (all_measured()) return;
    const TableCells cells = this->cells();
    const Shading<double> shading = this->shading({});
    std::vector<std::pair<double, std::size_t>> errors;
    for (std::size_t i = node_count(); i < samples_->size(); ++i)
        errors.push_back({area_error(shading, (*samples_)[i].k, area_at(i)), i});
    const std::size_t kept = std::min(errors.size(), worst_looked_at);
    std::partial_sort(errors.begin(), errors.begin() + static_cast<long>(kept), errors.end(),
                      [](const auto& a, const auto& b) {
                          return a.first != b.first ? a.first > b.first : a.second < b.second;
                      });
    std::set<int> looked_at;
    for (std::size_t i = 0; i < kept; ++i)
        for (const int cell : cells.cells_round((*samples_)[errors[i].second].point)) looked_at.insert(cell);
    std::vector<Sample> samples;
    for (const int cell : looked_at)
        for (const TablePoint& point : cells.every_place_of(cell)) samples.push_back(sample_at(point));
    add_samples(std::move(samples), workers);
}

TableCells AreaTable::cells() const { return {nodes_, grid_->symmetry()}; }

int AreaTable::strewn_directions() const {
    return quality_ == Quality::draft ? draft_between : std::max(final_between, cells().count());
}

bool AreaTable::all_measured() const { return cells().flat() || 3 * cells().count() <= strewn_directions(); }

std::size_t AreaTable::node_count() const {
    return static_cast<std::size_t>(nodes_.azimuth) * static_cast<std::size_t>(nodes_.polar);
}

AreaTable::Sample AreaTable::sample_at(const TablePoint& point) const {
    return {grid_->area_direction(point.column / (nodes_.polar - 1), point.row), point};
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
    shape.nodes_w = nodes_.polar;
    shape.area_offset = 0;
    result.data = data_.data();
    return result;
}

void AreaTable::tell(std::vector<KnownArea>& known) const {
    for (std::size_t i = 0; i < samples_->size(); ++i) known.push_back({(*samples_)[i].k, area_at(i)});
}

// What an A that is off by 1 at each node makes of g's error.
std::vector<double> AreaTable::node_weights(const Shading<double>& shading) const {
    std::vector<double> weights(node_count());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const dvec3 k = (*samples_)[i].k;
        weights[i] = area_error(shading, k, area_at(i) + shading.table_spot(k).scale, area_at(i));
    }
    return weights;
}

void AreaTable::search(const Shading<double>& material, double enough, Search how, AxisError& error,
                       std::vector<KnownArea>& known, Workers& workers) const {
    const Shading<double> shading = this->shading(material);
    const TableCells cells = this->cells();
    const std::size_t first = known.size();
    const bool thorough = how == Search::thorough;
    WorstSearch search(cells, [&](const std::vector<TablePoint>& points) {
        const std::size_t begin = known.size();
        known.resize(begin + points.size());
        std::vector<double> errors(points.size());
        workers.for_each(static_cast<int>(points.size()), [&](int i) {
            const std::size_t at = static_cast<std::size_t>(i);
            const dvec3 k = not_below_lowest(sample_at(points[at]).k);
            known[begin + at] = {k, distribution_->projected_area(k)};
            errors[at] = area_error(shading, k, known[begin + at].g);
        });
        return errors;
    });
    search.look_at_bends(cell_bends(nodes_, grid_->symmetry(), data_.data(), node_weights(shading)),
                         thorough ? cells.count() : std::max(cells.count() / cells_each, cells_min),
                         thorough || !all_measured());
    if (thorough) search.look_at(cells.beside_horizon(2));
    std::vector<TablePoint> points;
    std::vector<double> errors;
    for (std::size_t i = node_count(); i < samples_->size(); ++i) {
        points.push_back((*samples_)[i].point);
        errors.push_back(area_error(shading, (*samples_)[i].k, area_at(i)));
    }
    search.know(points, errors);
    if (search.worst() > enough) search.climb(thorough ? thorough_climbs : climbs);
    search.add_to(error);
    error.all.directions += static_cast<int>(known.size() - first);
}

double AreaTable::worst_at(const Shading<double>& material, const std::vector<KnownArea>& known,
                           Workers& workers) const {
    const Shading<double> shading = this->shading(material);
    std::vector<double> errors(known.size());
    workers.for_each(static_cast<int>(known.size()), [&](int i) {
        const KnownArea& area = known[static_cast<std::size_t>(i)];
        errors[static_cast<std::size_t>(i)] = area_error(shading, area.k, area.g);
    });
    return summarise(errors).worst;
}

AxisError AreaTable::measure(const Shading<double>& material) const {
    const Shading<double> shading = this->shading(material);
    AxisError error;
    std::vector<double> errors;
    for (std::size_t i = node_count(); i < samples_->size(); ++i) {
        const Sample& sample = (*samples_)[i];
        errors.push_back(area_error(shading, sample.k, area_at(i)));
        if (sample.point.place == TablePlace::along_polar)
            error.polar = worse_error(error.polar, errors.back());
        if (sample.point.place == TablePlace::along_azimuth)
            error.azimuth = worse_error(error.azimuth, errors.back());
    }
    error.all = summarise(errors);
    return error;
}

}  // namespace nacre
