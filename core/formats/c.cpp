// A C header with the tables as constants.
#include "core/formats/c_header.h"
#include "core/formats/export_format.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return ExportWriter(c_header(design, *bake(design, settings.bake, stop, progress), settings.prefix));
}

}  // namespace

const ExportFormat c_format{
    .name = "c",
    .title = "C header",
    .about =
        "one C99 header with {prefix}_brdf, {prefix}_sample and {prefix}_pdf, and its tables as constants",
    .next =
        "Include {file} in the renderer's plug-in, in C or in C++; it needs <math.h> alone.\n"
        "Define NACRE_FLOAT before that to compute in float instead of double.\n"
        "Turn the unit vectors to the light and to the viewer into the surface's frame: x tangent, y "
        "bitangent, z normal.\n"
        "Call {prefix}_brdf(to_light, to_viewer, rho), or {prefix}_sample() to draw a direction to the "
        "light. docs/renderers/c.md has both.",
    .extension = ".h",
    .has_names = true,
    .has_error = false,
    .holds = Holdings(Holding::exact),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
