#include "app/designer/status.h"

#include <fmt/core.h>

namespace nacre {
namespace {

std::string size_text(const Tables& tables) {
    const auto& plan = tables.plan;
    const std::string nodes = plan.nodes.psi > 1 ? fmt::format("{} \u00d7 {}", plan.nodes.w, plan.nodes.psi)
                                                 : fmt::format("{}", plan.nodes.w);
    const double kilobytes = static_cast<double>(tables.table_floats() * sizeof(float)) / 1024;
    return fmt::format("{} nodes, {}, {:.1f} kB", nodes, name_of(plan.symmetry.symmetry), kilobytes);
}

std::string time_text(double seconds) {
    return seconds < 1 ? fmt::format("{:.0f} ms", seconds * 1e3) : fmt::format("{:.1f} s", seconds);
}

}  // namespace

std::string tables_text(const Tables& tables) {
    const bool draft = tables.plan.quality == Quality::draft;
    std::string text =
        fmt::format("{}   {}   {}", draft ? "Draft" : "Final", size_text(tables), time_text(tables.seconds));
    text += fmt::format("   g within {:.2g} %", tables.errors.area.worst * 100);
    if (tables.plan.albedo) text += fmt::format(", R within {:.2g} %", tables.errors.albedo.worst * 100);
    return text;
}

}  // namespace nacre
