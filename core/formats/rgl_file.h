// The file of a measured material (RGL, EPFL), from a baked design.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "core/bake/tables.h"
#include "core/formats/export_format.h"

namespace nacre {

enum class RglColours {
    rgb,       // `rgb`, for RGB renderers
    spectral,  // `spectra` at primary_wavelengths, for spectral ones
};

// What of the design a file of limited size holds.
struct RglError {
    double misplaced;     // part of the light that leaves another way, over all pairs of directions
    double median;        // of |value - exact|/exact, of pairs that facets mirror into one another
    double ninety_fifth;  // its 95th percentile
};

struct RglFile {
    std::string bytes;
    RglError error;
};

// The smallest of some sizes whose `misplaced` is at most `error`; else the largest, of at most 1 MB where
// the design is isotropic and 24 MB elsewhere. Its description says what was reached. Throws BakeCancelled.
RglFile rgl_file(const Design& design, const std::shared_ptr<const Tables>& tables, RglColours colours,
                 double error, const std::stop_token& stop, const std::function<void(double)>& progress);

// Bakes the design and writes that.
ExportWriter rgl_writer(const Design& design, const ExportSettings& settings, RglColours colours,
                        const std::stop_token& stop, const std::function<void(double)>& progress);

}  // namespace nacre
