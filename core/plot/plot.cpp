#include "core/plot/plot.h"

#include <algorithm>
#include <cmath>

#include "core/plot/pair_plots.h"
#include "core/plot/section_plots.h"

namespace nacre {
namespace {

struct KindEntry {
    PlotKind kind;
    const char* name;
    Plot (*make)(const Tables&, const PlotSettings&);
};

constexpr std::array<KindEntry, plot_kinds> entries = {{
    {PlotKind::albedo, "albedo", albedo_plot},
    {PlotKind::masking, "masking", masking_plot},
    {PlotKind::density, "density", density_plot},
    {PlotKind::fresnel, "fresnel", fresnel_plot},
    {PlotKind::lobe, "lobe", lobe_plot},
    {PlotKind::shape, "lobe3d", shape_plot},
    {PlotKind::slice, "slice", slice_plot},
}};

const KindEntry& entry_of(PlotKind kind) { return entries[static_cast<std::size_t>(kind)]; }

}  // namespace

double CurvePlot::value(std::size_t of, double where) const {
    const std::vector<double>& values = series[of].values;
    const auto after = std::lower_bound(at.begin(), at.end(), where);
    if (after == at.begin()) return values.front();
    if (after == at.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - at.begin());
    const double t = (where - at[i - 1]) / (at[i] - at[i - 1]);
    return std::lerp(values[i - 1], values[i], t);
}

bool needs_albedo(const PlotSettings& settings) { return settings.kind == PlotKind::albedo; }

std::optional<Plot> make_plot(const Tables& tables, const PlotSettings& settings) {
    if (needs_albedo(settings) && !tables.shading.kinds.albedo) return {};
    return entry_of(settings.kind).make(tables, settings);
}

const char* name_of(PlotKind kind) { return entry_of(kind).name; }

std::optional<PlotKind> plot_kind(const std::string& name) {
    for (const KindEntry& entry : entries)
        if (entry.name == name) return entry.kind;
    return {};
}

}  // namespace nacre
