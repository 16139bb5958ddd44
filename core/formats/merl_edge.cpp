// MERL's format, with values at the bins' lower edges.
#include "core/formats/merl_file.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    return merl_writer(design, settings, 0, stop, progress);
}

}  // namespace

const ExportFormat merl_edge_format{
    .name = "merl-edge",
    .title = "MERL measured BRDF, bin edges",
    .about =
        "one .binary file as MERL's measured isotropic BRDFs, 35 MB, with values at the bins' lower edges",
    .next =
        "Open {file} where measured BRDFs of MERL are read: BRDF Explorer, Falcor, libbsdf and others.\n"
        "Readers that interpolate from bins' lower edges, as libbsdf does, want this file. For one that "
        "takes the nearest bin export merl.\n"
        "Turn smoothing between bins on where the reader has it: a narrow highlight is a few bins wide.",
    .extension = ".binary",
    .has_names = false,
    .has_error = false,
    .holds = Holdings(Holding::fitted)
                 .but(Holding::refused, {Feature::anisotropic, Feature::painted, Feature::leaning}),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
