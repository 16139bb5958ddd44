// Median slopes of the facets of p: widths that every p has, also GGX and velvet, whose
// slopes have no second moment.
#pragma once

#include "core/model/facet_distribution.h"

namespace nacre {

// In the tangent plane, along the principal axes of <h h'> (which are p's mirror axes where it mirrors): half
// of the facets, by the area they show to n, have a slope |h.axis|/(h.n) of at most `median`.
struct FacetSlopes {
    double azimuth = 0;  // radians from the tangent to the first axis, along which slopes are smallest
    dvec2 median{0};
};

// Of the facets above the horizon; p needs some, as every design that bakes has.
FacetSlopes facet_slopes(const FacetDistribution& p);

// The sigma of Oren and Nayar's facets that are as steep in the mean square as p's, radians: theirs are
// spread as exp(-theta^2/(2 sigma^2)) a steradian, which for a narrow p has <theta^2> = 2 sigma^2.
double oren_nayar_sigma(const FacetDistribution& p);

}  // namespace nacre
