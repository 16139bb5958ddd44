#include "core/bake/albedo_table.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

// Beyond those between nodes.
constexpr int grazing_probes = 24;

struct Probe {
    dvec3 k;
    TablePlace place;
};

std::vector<Probe> choose_probes(const StretchedGrid& grid, const TableSize& nodes, int count) {
    const TableCells cells({nodes.v, nodes.rho}, grid.symmetry());
    std::vector<TablePoint> points = count < cells.count() ? cells.strewn(count) : cells.one_a_cell();
    for (const TablePoint& point : cells.grazing(grazing_probes)) points.push_back(point);
    std::vector<Probe> probes;
    for (const TablePoint& point : points)
        probes.push_back(
            {grid.albedo_direction(point.column / cells.columns(), point.row, nodes.rho), point.place});
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
        if (probes[i].place == TablePlace::along_polar) error_.polar = worse_error(error_.polar, errors[i]);
        if (probes[i].place == TablePlace::along_azimuth)
            error_.azimuth = worse_error(error_.azimuth, errors[i]);
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
