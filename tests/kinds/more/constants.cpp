// N and g(n), as text.
#include <fmt/core.h>

#include "core/formats/export_format.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    const auto tables = bake(design, settings.bake, stop, progress);
    const auto& surface = tables->shading.surface;
    return ExportWriter(fmt::format("N {}\ng {}\n", surface.N, surface.tables.g_normal));
}

}  // namespace

const ExportFormat constants_format{.name = "constants",
                                    .title = "Constants",
                                    .about = "N and g(n), as text",
                                    .next = "Read {file} line by line: a name and its number.",
                                    .extension = ".txt",
                                    .has_names = false,
                                    .has_error = false,
                                    .holds = Holdings(Holding::exact),
                                    .files = one_file,
                                    .prepare = prepare};

}  // namespace nacre
