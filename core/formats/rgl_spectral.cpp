// A measured material of RGL's format with spectra, for spectral renderers.
#include "core/formats/export_format.h"
#include "core/formats/rgl_file.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return rgl_writer(design, settings, RglColours::spectral, stop, progress);
}

}  // namespace

const ExportFormat rgl_spectral_format{
    .name = "rgl-spectral",
    .title = "Measured material, spectral",
    .about =
        "one _spec.bsdf file that Mitsuba 3 renders in its spectral variants, and pbrt-v4, with their stock "
        "material \u201cmeasured\u201d",
    .next =
        "In a scene of Mitsuba 3 write <bsdf type=\"measured\"><string name=\"filename\" "
        "value=\"{file}\"/></bsdf>.\n"
        "In pbrt-v4 write Material \"measured\" \"string filename\" [ \"{file}\" ].\n"
        "In Mitsuba choose a variant with spectral in its name.\n"
        "An anisotropic design follows the surface's tangent: give the mesh texture coordinates.\n"
        "docs/renderers/mitsuba.md has a whole scene.",
    .extension = "_spec.bsdf",
    .has_names = false,
    .has_error = true,
    .holds = Holdings(Holding::fitted),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
