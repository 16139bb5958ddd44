#include "core/shading/term.h"

#include <algorithm>

namespace nacre {
namespace {

constexpr TermInfo terms[] = {
    {Term::total, "total", "All", "The whole BRDF: specular and diffuse."},
    {Term::density, "p", "p",
     "Facets: how many of them mirror the light into the eye, p(h) in 1/sr. The shape of the highlight "
     "before "
     "anything hides it (h halfway between light and eye)."},
    {Term::masking1, "P1", "P1",
     "Shadowing: the part of the facets turned to the light that the light reaches, P(k1) = (k1.n) N/g(k1) "
     "(Ashikhmin 2000, eq. 25). 1 is all of them; what is lost darkens grazing light."},
    {Term::masking2, "P2", "P2",
     "Masking: the part of the facets turned to the eye that the eye sees, P(k2) = (k2.n) N/g(k2) "
     "(eq. 25). What is lost darkens the rim."},
    {Term::fresnel, "F", "F",
     "Fresnel: how much light each of those facets sends back, F(k.h). It rises to 1 where light comes from "
     "behind."},
    {Term::specular, "specular", "Specular",
     "The light of one reflection at the facets: p N F/(4 g(k1) g(k2)) (eq. 26)."},
    {Term::multibounce, "multibounce", "Bounces",
     "The light of two or more reflections between the facets, in the model that the design has for it."},
    {Term::retro, "retro", "Retro",
     "The part of the specular term that goes back to where the light came from: weight [\u03c1(k1, T k2) + "
     "\u03c1(T k1, k2)]/2, T half a turn about n."},
    {Term::diffuse, "diffuse", "Diffuse",
     "The light that enters and leaves again elsewhere; for the coupled model what the specular term leaves "
     "over (eq. 27 to 30)."},
    {Term::coat, "coat", "Coat",
     "What the coat adds: its own highlight, and the light that has gone back and forth between it and what "
     "lies "
     "beneath. The other terms are seen through it."},
    {Term::inverse_areas, "1/gg", "1/(g g)",
     "What brightens toward the rim: 1 over the projected facet areas that light and eye see, 1/(g(k1) "
     "g(k2)) "
     "(eq. 18 and 26). With a correlated masking, what stands in its place."},
};

}  // namespace

std::span<const TermInfo> all_terms() { return terms; }

const TermInfo& info(Term term) {
    return *std::find_if(std::begin(terms), std::end(terms),
                         [term](const TermInfo& candidate) { return candidate.term == term; });
}

std::optional<Term> term_by_name(std::string_view name) {
    for (const TermInfo& candidate : terms)
        if (candidate.name == name) return candidate.term;
    return {};
}

std::vector<std::string> term_names() {
    std::vector<std::string> names;
    for (const TermInfo& term : terms) names.emplace_back(term.name);
    return names;
}

bool is_factor(Term term) {
    switch (term) {
        case Term::total:
        case Term::specular:
        case Term::multibounce:
        case Term::retro:
        case Term::diffuse:
        case Term::coat:
            return false;
        case Term::density:
        case Term::masking1:
        case Term::masking2:
        case Term::fresnel:
        case Term::inverse_areas:
            return true;
    }
    return false;
}

bool has_term(const ShadingKinds& kinds, Term term) {
    if (term == Term::multibounce) return kinds.bounces();
    if (term == Term::coat) return kinds.coated();
    return term != Term::retro || kinds.retro;
}

}  // namespace nacre
