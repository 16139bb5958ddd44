// A measured material of RGL's format with colours, for RGB renderers.
#include "core/formats/export_format.h"
#include "core/formats/rgl_file.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return rgl_writer(design, settings, RglColours::rgb, stop, progress);
}

}  // namespace

const ExportFormat rgl_rgb_format{
    .name = "rgl-rgb",
    .title = "Measured material, RGB",
    .about =
        "one _rgb.bsdf file that Mitsuba 3 renders in its RGB variants with its stock plug-in "
        "\u201cmeasured\u201d",
    .next =
        "In a scene of Mitsuba 3 write <bsdf type=\"measured\"><string name=\"filename\" "
        "value=\"{file}\"/></bsdf>.\n"
        "Choose a variant whose name ends in _rgb.\n"
        "An anisotropic design follows the surface's tangent: give the mesh texture coordinates.\n"
        "docs/renderers/mitsuba.md has a whole scene.",
    .extension = "_rgb.bsdf",
    .has_names = false,
    .has_error = true,
    .holds = Holdings(Holding::fitted),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
