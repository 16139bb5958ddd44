#include "core/model/spectral/fresnel_curve.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/model/spectral/spectral_colour.h"

namespace nacre {
namespace {

using glm::dvec3;

constexpr double wanted_error = 5e-4;

double largest(dvec3 v) { return std::max({v.x, v.y, v.z}); }

// Colours at even places, which are doubled again and again.
struct Samples {
    const Reflectance& reflectance;
    std::vector<dvec3> colours = {};
    double clipped = 0;

    dvec3 at(double place) {
        const GamutColour colour = clip_to_gamut(reflectance(place * place));
        clipped = std::max(clipped, colour.clipped);
        return colour.colour;
    }

    // At the middles between the samples; returns how far straight lines are from them at most.
    double refine() {
        const std::size_t count = colours.size();
        std::vector<dvec3> finer;
        double error = 0;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(count - 1);
            const dvec3 middle = at(place);
            error = std::max(error, largest(glm::abs(middle - 0.5 * (colours[i] + colours[i + 1]))));
            finer.push_back(colours[i]);
            finer.push_back(middle);
        }
        finer.push_back(colours.back());
        colours = std::move(finer);
        return error;
    }
};

FresnelCurve of_every(std::size_t step, const Samples& samples, double error) {
    FresnelCurve curve;
    curve.clipped = samples.clipped;
    curve.error = error;
    for (std::size_t i = 0; i < samples.colours.size(); i += step, ++curve.nodes)
        for (int c = 0; c < 3; ++c) curve.values.push_back(static_cast<float>(samples.colours[i][c]));
    return curve;
}

}  // namespace

FresnelCurve tabulated(const Reflectance& reflectance) {
    Samples samples{reflectance};
    for (int i = 0; i <= curve_intervals_min; ++i)
        samples.colours.push_back(samples.at(static_cast<double>(i) / curve_intervals_min));
    // The middles of one size are nodes of the next.
    for (int intervals = curve_intervals_min;; intervals *= 2) {
        const double error = samples.refine();
        if (error <= wanted_error || intervals == curve_intervals_max) return of_every(2, samples, error);
    }
}

}  // namespace nacre
