#include "app/designer/status.h"

#include <fmt/core.h>

#include "core/design/design_check.h"
#include "core/model/polar_angles.h"
#include "ui/canvas_grid.h"

namespace nacre {
namespace {

std::string size_text(const Tables& tables) {
    const TableSize& size = tables.size;
    const std::string nodes =
        size.psi > 1 ? fmt::format("{} \u00d7 {}", size.w, size.psi) : fmt::format("{}", size.w);
    const Symmetry symmetry = tables.needs.symmetry.symmetry;
    const double kilobytes = static_cast<double>(tables.table_floats() * sizeof(float)) / 1024;
    return fmt::format("{} nodes, {}, {:.1f} kB", nodes,
                       symmetry == Symmetry::none ? "no symmetry" : name_of(symmetry), kilobytes);
}

std::string time_text(const Tables& tables) {
    const double seconds = tables.bake_seconds;
    return seconds < 1 ? fmt::format("{:.0f} ms", seconds * 1e3) : fmt::format("{:.1f} s", seconds);
}

std::string error_text(const Tables& tables) {
    std::string text = fmt::format("g within {:.2g} %", tables.errors.area.worst * 100);
    if (tables.needs.albedo) text += fmt::format(", R within {:.2g} %", tables.errors.albedo.worst * 100);
    if (tables.shading.kinds.matt_facets())
        text += fmt::format(", facets within {:.2g} %", tables.errors.facets.worst * 100);
    if (!tables.bounces) return text;
    if (tables.bounces->misplaced)
        return text + fmt::format(", bounces: {:.2g} % misplaced", *tables.bounces->misplaced * 100);
    return text + ", bounces: even";
}

}  // namespace

ui::TablesStatus status_of(const Tables& tables) {
    ui::TablesStatus status;
    status.quality = tables.quality == Quality::draft ? "Draft" : "Final";
    status.tables = fmt::format("{}   {}   {}", size_text(tables), time_text(tables), error_text(tables));
    for (const Omission& omission : tables.omissions)
        status.left_out.push_back(omission.what + ": " + omission.why);
    const double tilt = polar_angle(tables.mean);
    status.valid = tilt < ui::tilt_noticed;
    status.validity = status.valid ? "mean normal ok" : fmt::format("mean normal tilted {:.1f}\u00b0", tilt);
    if (const std::string note = energy_note(tables.intensity); !note.empty()) {
        status.valid = false;
        status.creates_energy = true;
        status.validity += ", " + note;
    }
    return status;
}

}  // namespace nacre
