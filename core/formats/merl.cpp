// MERL's format, with values at the bins' centres.
#include "core/formats/merl_file.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return merl_writer(design, settings, 0.5, stop, progress);
}

}  // namespace

const ExportFormat merl_format{
    .name = "merl",
    .title = "MERL measured BRDF",
    .about = "one .binary file as MERL's measured isotropic BRDFs, 35 MB, with values at the bins' centres",
    .next =
        "Open {file} where measured BRDFs of MERL are read: BRDF Explorer, Falcor, libbsdf and others.\n"
        "Readers that take the nearest bin want this file. For one that interpolates from bins' lower edges, "
        "as libbsdf does, export merl-edge.\n"
        "Turn smoothing between bins on where the reader has it: a narrow highlight is a few bins wide.",
    .extension = ".binary",
    .has_names = false,
    .has_error = false,
    .holds = Holdings(Holding::fitted)
                 .but(Holding::refused, {Feature::anisotropic, Feature::painted, Feature::leaning}),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
