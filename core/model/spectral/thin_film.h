// Reflectance of a stack of thin films by one wavelength.
#pragma once

#include <complex>
#include <span>

namespace nacre {

// One film: index of refraction, at least 1, and thickness in nm.
struct OpticalFilm {
    double ior;
    double thickness;
};

// Of films between a medium of index `above` and a substrate of index n + i k, the outermost first,
// unpolarised: what Airy's sum gives for one film (Born & Wolf, sec. 7.6 and 14.4.1), from the substrate up
// for more. Wavelength in nm, cosine in that medium from 0 to 1. 0 to 1; where every index is the same
// nothing is reflected.
double film_reflectance(std::span<const OpticalFilm> films, std::complex<double> substrate, double wavelength,
                        double cosine, double above = 1);

}  // namespace nacre
