// The terms that a BRDF is made of, each by itself.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/shading.h"

namespace nacre {

// Of a pair of directions, as shaders/shared/brdf.glsl and terms.glsl compute them.
enum class Term {
    total,          // the BRDF, 1/sr
    specular,       // its specular term with its weight, 1/sr
    multibounce,    // light of two or more bounces between facets, 1/sr
    retro,          // what of the specular term goes back to where the light came from, 1/sr
    diffuse,        // everything else beneath a coat, 1/sr
    coat,           // what a coat adds to what lies beneath it, 1/sr
    density,        // p(h), 1/sr
    masking1,       // P(k1)
    masking2,       // P(k2)
    fresnel,        // F(k.h), a colour
    inverse_areas,  // 1/(g(k1) g(k2)), p normalised to 1
};

struct TermInfo {
    Term term;
    const char* name;     // on the command line
    const char* label;    // on a button
    const char* meaning;  // for the look, with its equation
};

std::span<const TermInfo> all_terms();
const TermInfo& info(Term term);

std::optional<Term> term_by_name(std::string_view name);
std::vector<std::string> term_names();

// Whether it is a factor of each pair of directions; the others are radiance, which sums over the lights.
bool is_factor(Term term);

// Whether a design of these kinds has the term; of one that does not it is 0.
bool has_term(const ShadingKinds& kinds, Term term);

}  // namespace nacre
