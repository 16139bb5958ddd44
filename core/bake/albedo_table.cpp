#include "core/bake/albedo_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

// Beyond those between nodes.
constexpr int grazing_probes = 24;

enum class Place { along_v, along_rho, centre };

struct Probe {
    dvec3 k;
    Place place;
};

std::vector<Probe> choose_probes(const StretchedGrid& grid, const TableSize& nodes, int count) {
    const bool closed = grid.shape().symmetry == Shading<double>::SYMMETRY_NONE;
    const int columns = nodes.v - 1, rows = nodes.rho == 1 ? 1 : closed ? nodes.rho : nodes.rho - 1;
    const int cells = columns * rows;
    std::vector<Probe> probes;
    count = std::min(count, cells);
    for (int i = 0; i < count; ++i) {
        const int cell = count == cells ? i : strewn_cell(i, columns, rows);
        const Place place = nodes.rho == 1 || i % 3 == 0 ? Place::along_v
                            : i % 3 == 1                 ? Place::along_rho
                                                         : Place::centre;
        const double column = cell % columns + (place == Place::along_rho ? 1 : 0.5);
        const double row = cell / columns + (place == Place::along_v ? 0 : 0.5);
        probes.push_back({grid.albedo_direction(column / columns, row, nodes.rho), place});
    }
    // The last cell before the horizon may hold a layer thinner than itself.
    for (int i = 0; i < grazing_probes; ++i) {
        const double column = columns - std::exp2(-2 - i % 12);
        const double row = nodes.rho == 1 ? 0 : rows * std::fmod((i + 0.5) * std::numbers::phi, 1.0);
        probes.push_back({grid.albedo_direction(column / columns, row, nodes.rho), Place::centre});
    }
    return probes;
}

}  // namespace

AlbedoTable::AlbedoTable(const AlbedoRules& rules, const BakePlan& plan, Workers& workers) {
    const int columns = plan.nodes.v, count = columns * plan.nodes.rho, channels = plan.fresnel_tables;
    const FacetDistribution& distribution = *rules.area().distribution();
    const Shading<double>& shading = rules.shading();
    data_.resize(static_cast<std::size_t>(count * (1 + channels)));
    workers.for_each(count, [&](int i) {
        const dvec3 k = rules.area().grid().albedo_direction(static_cast<double>(i % columns) / (columns - 1),
                                                             i / columns, plan.nodes.rho);
        const double g = distribution.projected_area(k), kept = shading.clamped_part(k, g);
        AlbedoValues values = rules.nodes()(k, g);
        for (double& value : values) value = kept > 0 ? value / kept : 0;
        data_[static_cast<std::size_t>(i)] = static_cast<float>(values[0]);
        const dvec3 f = channels == 1 ? dvec3{Shading<double>::schlick_weight(k.z)} : shading.fresnel(k.z);
        for (int c = 0; c < channels; ++c)
            data_[static_cast<std::size_t>(i + (c + 1) * count)] =
                static_cast<float>(values[static_cast<std::size_t>(c + 1)] - f[c] * values[0]);
    });
    measure(rules, plan, workers);
}

void AlbedoTable::measure(const AlbedoRules& rules, const BakePlan& plan, Workers& workers) {
    const FacetDistribution& distribution = *rules.area().distribution();
    Shading<double> shading = rules.shading();
    std::vector<float> data = rules.area().data();
    place(shading, plan, static_cast<int>(data.size()));
    data.insert(data.end(), data_.begin(), data_.end());
    shading.data = data.data();
    const std::vector<Probe> probes = choose_probes(rules.area().grid(), plan.nodes, rules.most_probes());
    std::vector<double> errors(probes.size());
    workers.for_each(static_cast<int>(probes.size()), [&](int i) {
        const dvec3 k = probes[static_cast<std::size_t>(i)].k;
        errors[static_cast<std::size_t>(i)] =
            albedo_error(shading, k, rules.probes()(k, distribution.projected_area(k)), plan.fresnel_tables);
    });
    error_.all = summarise(errors);
    for (std::size_t i = 0; i < probes.size(); ++i) {
        if (probes[i].place == Place::along_v) error_.polar = std::fmax(error_.polar, errors[i]);
        if (probes[i].place == Place::along_rho) error_.azimuth = std::fmax(error_.azimuth, errors[i]);
    }
}

void AlbedoTable::place(Shading<double>& shading, const BakePlan& plan, int offset) {
    auto& shape = shading.surface.tables;
    shape.nodes_v = plan.nodes.v;
    shape.nodes_rho = plan.nodes.rho;
    shape.albedo_offset = offset;
    shape.residual_offset = offset + plan.nodes.v * plan.nodes.rho;
}

}  // namespace nacre
