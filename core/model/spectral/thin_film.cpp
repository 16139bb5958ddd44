#include "core/model/spectral/thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using Complex = std::complex<double>;

// A medium, and a wave in it whose sine in air would be `sine`.
struct Wave {
    Complex index;
    Complex cosine;

    // Of the two roots the one that decays with depth.
    Wave(Complex medium, double sine)
        : index(medium), cosine(std::sqrt(1.0 - sine * sine / (medium * medium))) {
        if ((index * cosine).imag() < 0) cosine = -cosine;
    }
};

// The amplitudes that a border reflects, of both polarisations.
struct Amplitudes {
    Complex s, p;
};

Complex quotient(Complex a, Complex b) { return (a - b) / (a + b); }

Amplitudes border(const Wave& above, const Wave& below) {
    if (above.index == below.index) return {0, 0};
    return {quotient(above.index * above.cosine, below.index * below.cosine),
            quotient(below.index * above.cosine, above.index * below.cosine)};
}

Complex beneath_film(Complex border, Complex below, Complex phase) {
    return (border + below * phase) / (1.0 + border * below * phase);
}

}  // namespace

double film_reflectance(std::span<const OpticalFilm> films, Complex substrate, double wavelength,
                        double cosine, double above) {
    const double c = std::max(cosine, 1e-7);  // at 0 a film of index 1 over another medium would be 0/0
    const double sine = above * std::sqrt(std::max(1 - c * c, 0.0));
    Wave below(substrate, sine);
    const auto index_above = [&](std::size_t i) { return i == 0 ? above : films[i - 1].ior; };
    Amplitudes r = border(Wave(index_above(films.size()), sine), below);
    for (std::size_t i = films.size(); i > 0; --i) {
        const Wave film(films[i - 1].ior, sine);
        const Complex turn{0, 4 * std::numbers::pi * films[i - 1].thickness / wavelength};
        const Complex phase = std::exp(turn * film.index * film.cosine);
        const Amplitudes top = border(Wave(index_above(i - 1), sine), film);
        r = {beneath_film(top.s, r.s, phase), beneath_film(top.p, r.p, phase)};
    }
    return 0.5 * (std::norm(r.s) + std::norm(r.p));
}

}  // namespace nacre
