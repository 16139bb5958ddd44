// HLSL functions with the tables as constants.
#include "core/formats/export_format.h"
#include "core/formats/hlsl_export.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return ExportWriter(hlsl_export(design, *bake(design, settings.bake, stop, progress), settings.prefix));
}

}  // namespace

const ExportFormat hlsl_format{
    .name = "hlsl",
    .title = "HLSL functions",
    .about = "one file with {prefix}_brdf, {prefix}_sample and {prefix}_pdf, and its tables as constants",
    .next =
        "Include {file} in the shader, before what calls it.\n"
        "Turn the unit vectors to the light and to the viewer into the surface's frame: x tangent, y "
        "bitangent, z normal.\n"
        "Add {prefix}_brdf(to_light, to_viewer) * light * to_light.z for each light, in linear colours.\n"
        "docs/renderers/hlsl.md says how in Unreal and in Unity.",
    .extension = ".hlsl",
    .has_names = true,
    .has_error = false,
    .holds = Holdings(Holding::exact),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
