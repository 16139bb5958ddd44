// The methods of computing and storing g and R that the report compares: each a list of settings, rising in
// cost, and each setting a function from a design to a table that can be read.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/bake/albedo.h"
#include "core/design/design.h"

namespace nacre {

enum class Wanted { area, area_and_albedo };

// The table that a method makes of a design. Directions are unit, k.z >= 0.
struct StoredTable {
    std::function<double(dvec3 k)> area;  // g, p normalised to 1
    // R with F = 1 and with f0 = 0; where it is wanted.
    std::function<AlbedoValues(dvec3 k)> albedo = {};
    std::size_t bytes = 0;  // of all that is stored
};

struct MethodSetting {
    std::string label;
    // From cold: only the design is given. One thread. Throws BakeCancelled soon after a stop is requested.
    std::function<StoredTable(Wanted wanted, const std::stop_token& stop)> make;
};

enum class MethodKind { monte_carlo, cubature, plain_grid, stretched, bake, harmonics };

struct Method {
    MethodKind kind;
    std::string name;
    std::string about;  // how it computes and how it stores
    std::vector<MethodSetting> settings = {};
    bool area = true;  // whether it computes g
    bool albedo = true;
    std::string left_out = {};  // why there are no settings
};

// `design` has Schlick's Fresnel factor and no diffuse term, and outlives the methods, as for all of these.
std::vector<Method> all_methods(const Design& design, const std::stop_token& stop);

// The paper's 200-point grid, 10 in theta by 20 in phi (Ashikhmin 2000, sec. 5.2). The paper does not say how
// its Monte Carlo draws: here facets about k and directions about n, both by the cosine.
Method monte_carlo_method(const Design& design);

// The same grid, each node by adaptive Gauss-Kronrod integration in the lobes' own coordinates.
Method cubature_method(const Design& design);

// Such grids of rising size with exact g and the bake's own R in the nodes: what is left is interpolation.
Method plain_grid_method(const Design& design);

// The stretched tables of rising size.
Method stretched_method(const Design& design);

// The draft and the final bake as they come.
Method bake_method(const Design& design);

// g as a sum of spherical harmonics: the convolution of p with max(0, cos).
Method harmonic_method(const Design& design, const std::stop_token& stop);

}  // namespace nacre
