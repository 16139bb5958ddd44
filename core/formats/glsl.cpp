// A GLSL function with the tables as constants.
#include "core/formats/export_format.h"
#include "core/formats/glsl_export.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return ExportWriter(glsl_export(design, *bake(design, settings.bake, stop, progress), settings.prefix));
}

}  // namespace

const ExportFormat glsl_format{
    .name = "glsl",
    .title = "GLSL function",
    .about = "one file with the function {prefix}_brdf(k1, k2) and its tables as constants",
    .next =
        "Paste {file} into the fragment shader, after #version 330 or later and before main().\n"
        "Turn the unit vectors to the light and to the viewer into the surface's frame: x tangent, y "
        "bitangent, z normal.\n"
        "Add {prefix}_brdf(to_light, to_viewer) * light * to_light.z for each light, in linear colours.\n"
        "Apply sRGB or the display's own curve last. docs/glsl.md has a caller in 37 lines.",
    .extension = ".glsl",
    .has_names = true,
    .has_error = false,
    .holds = Holdings(Holding::exact),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
