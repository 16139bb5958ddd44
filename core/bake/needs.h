// What a design needs of the bake and what can be left out, for the bake, the
// reference, `info` and `eval` alike. The shader variant follows from the resulting tables
// (shading/shader_variant.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bake/albedo_values.h"
#include "core/bake/symmetry.h"
#include "core/design/design.h"

namespace nacre {

struct Needs {
    DistributionSymmetry symmetry;
    bool albedo =
        false;  // R(k) with F = 1, and with the design's Fresnel factor; what bounces leave is 1 - R
    int fresnel_tables = 0;  // of a facet. 0: F = 1 alone; 1: Schlick's weight; 3: exact, a colour each
    Tint tint = Tint::none;  // varied: of R every colour is wanted

    AlbedoLayout layout() const { return {fresnel_tables, tint}; }

    bool operator==(const Needs&) const = default;
};

struct MoreNeeds {
    bool albedo = false;  // R is wanted even if no diffuse term reads it (ambient light, the `tables` verb)
    std::optional<Symmetry> symmetry = {};  // use at most this symmetry
};

Needs needs_of(const Design& design, const MoreNeeds& more = {});

// What a bake or a shader can do without.
enum class Part {
    symmetric_nodes,  // of every table
    albedo,
    fresnel_table,
    fresnel_colours,  // a Fresnel table for each
    pictures,
    fresnel,
    masking,  // of another model
    diffuse
};

struct Omission {
    Part part;
    std::string what;
    std::string why;
};

// What the design does not need, `needs` being what it needs.
std::vector<Omission> omissions_of(const Design& design, const Needs& needs);

}  // namespace nacre
