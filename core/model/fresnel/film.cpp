#include "core/model/fresnel/film.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/spectral/fresnel_curve.h"
#include "core/model/spectral/spectral_colour.h"
#include "core/model/spectral/thin_film.h"

namespace nacre {
namespace {

using glm::dvec3;
using Complex = std::complex<double>;

// The index of what the films lie on, for each colour. A conductor's eta and k are those of its colour at
// every wavelength, so that without films F is the conductor's own.
struct BaseIndex {
    double wavelength;
    int colour;

    Complex operator()(const DielectricFresnel& base) const { return base.ior; }
    Complex operator()(const ConductorFresnel& base) const { return {base.eta[colour], base.k[colour]}; }
    Complex operator()(const MeasuredFresnel& base) const { return index_at(base.material, wavelength); }
};

double optical_thickness(const std::vector<FilmLayer>& stack) {
    double sum = 0;
    for (const FilmLayer& layer : stack) sum += layer.ior * layer.thickness;
    return sum;
}

// So many that the phase of the way there and back, 4 pi n d/lambda, turns by at most half a radian from one
// to the next.
int steps_per_nanometre(const std::vector<FilmLayer>& stack) {
    const double turn = 4 * std::numbers::pi * optical_thickness(stack) / (spectrum_begin * spectrum_begin);
    return std::max(1, static_cast<int>(std::ceil(turn / 0.5)));
}

}  // namespace

std::optional<KindFault> FilmFresnel::fault() const {
    const double thickness = optical_thickness(stack);
    if (thickness <= limits::film_optical_max) return {};
    return KindFault{
        "stack",
        fmt::format("the sum of ior times thickness must be at most {} nm", limits::film_optical_max),
        fmt::format("{:g}", thickness)};
}

Reflectance FilmFresnel::reflectance(double above) const {
    std::vector<OpticalFilm> films;
    for (const FilmLayer& layer : stack) films.push_back({layer.ior, layer.thickness});
    const bool coloured = std::holds_alternative<ConductorFresnel>(over);
    return [base = over, films, coloured, above,
            nodes = spectral_nodes(steps_per_nanometre(stack))](double cosine) {
        dvec3 colour{0};
        for (const SpectralNode& node : nodes) {
            dvec3 reflected{0};
            for (int c = 0; c < 3; ++c)
                reflected[c] = c > 0 && !coloured
                                   ? reflected[0]
                                   : film_reflectance(films, std::visit(BaseIndex{node.wavelength, c}, base),
                                                      node.wavelength, cosine, above);
            colour += node.weight * reflected;
        }
        return colour;
    };
}

ShaderFresnel FilmFresnel::shader(double above) const {
    static CurveMemory<FilmFresnel> memory;
    return {.curve = memory.curve_of(*this, above)};
}

std::vector<std::pair<const char*, FilmFresnel>> FilmFresnel::singular() {
    return {{"of index 1 on index 1", {DielectricFresnel{1}, {{1, 500}}}},
            {"soap, 2000 nm", {DielectricFresnel{1}, {{1.33, 2000}}}},
            {"titania on gold, 2000 nm", {MeasuredFresnel{Material::gold}, {{2.4, 2000}}}}};
}

FilmFresnel FilmFresnel::of_reflectance(const Reflectance& wanted) {
    const dvec3 f0 = wanted(1);
    if (std::max({f0.x, f0.y, f0.z}) < 0.2) return {DielectricFresnel::of_reflectance(wanted)};
    return {MeasuredFresnel::of_reflectance(wanted)};
}

}  // namespace nacre
