// A module for three.js.
#include "core/formats/export_format.h"
#include "core/formats/three_js.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    BakeOptions options = settings.bake;
    options.albedo = true;  // for ambient light
    return ExportWriter(
        three_js_module(design, *bake(design, options, stop, progress), settings.prefix, "material.js"));
}

}  // namespace

const ExportFormat three_format{
    .name = "three",
    .title = "three.js material",
    .about = "one JavaScript module whose material() is a ShaderMaterial around {prefix}_brdf(k1, k2)",
    .next =
        "Write import {{material}} from \"./{file}\" in a module that can import \"three\".\n"
        "Give material() to a mesh: it follows the scene's directional, point and ambient lights.\n"
        "Give the geometry a tangent attribute and call material({{tangents: true}}) where the grain "
        "matters.\n"
        "docs/renderers/three-js.md tells more.",
    .extension = ".js",
    .has_names = true,
    .has_error = false,
    .holds = Holdings(Holding::exact),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
