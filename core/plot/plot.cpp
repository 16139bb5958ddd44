#include "core/plot/plot.h"

#include <algorithm>
#include <cmath>

#include "core/plot/pair_plots.h"

namespace nacre {

double CurvePlot::value(std::size_t of, double where) const {
    const std::vector<double>& values = series[of].values;
    const auto after = std::lower_bound(at.begin(), at.end(), where);
    if (after == at.begin()) return values.front();
    if (after == at.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - at.begin());
    const double t = (where - at[i - 1]) / (at[i] - at[i - 1]);
    return std::lerp(values[i - 1], values[i], t);
}

double SlicePlot::angle(int index) const { return std::min(index * 90.0 / (side - 1), horizon); }

const PlotInfo& info(PlotKind kind) {
    static constexpr std::array list{
#define PLOT(name) &name##_plot,
#include "core/plot/plot_list.inc"
#undef PLOT
    };
    return *list[static_cast<std::size_t>(kind)];
}

PlotScales usual_scales() {
    PlotScales scales{};
    for (const PlotKind kind : plot_kinds) scales[static_cast<std::size_t>(kind)] = info(kind).logarithmic;
    return scales;
}

bool needs_albedo(const PlotSettings& settings) { return info(settings.kind).needs_albedo; }

std::optional<Plot> make_plot(const Tables& tables, const PlotSettings& settings) {
    if (needs_albedo(settings) && !tables.shading.kinds.albedo) return {};
    return info(settings.kind).make(tables, settings);
}

const char* name_of(PlotKind kind) {
    static constexpr std::array names{
#define PLOT(name) #name,
#include "core/plot/plot_list.inc"
#undef PLOT
    };
    return names[static_cast<std::size_t>(kind)];
}

std::optional<PlotKind> plot_kind(const std::string& name) {
    for (const PlotKind kind : plot_kinds)
        if (name_of(kind) == name) return kind;
    return {};
}

}  // namespace nacre
