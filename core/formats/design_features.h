// What a design may have that another program's format may not hold.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string_view>

#include "core/design/design.h"

namespace nacre {

enum class Feature {
    specular,     // the highlight itself
    anisotropic,  // p that turns with the surface
    painted,      // a layer that reads a picture
    leaning,      // a mean facet <h> that does not lie along n
    intensity,    // of the specular term, other than 1
    multibounce,  // light of two or more bounces between facets
    tint,         // layers of different reflectance
    coupled,      // the diffuse term that takes what the facets leave
    diffuse,      // any other diffuse term
    facets,       // matt facets
    film,         // a Fresnel factor of thin films
    coat,
    retro,       // retro-reflection
    correlated,  // masking and shadowing that depend on each other
};

struct FeatureInfo {
    Feature feature;
    std::string_view name;   // in JSON
    std::string_view title;  // in a table; "retro-reflection"
};

// In the order of the enumeration.
std::span<const FeatureInfo> all_features();
inline constexpr std::size_t feature_count = static_cast<std::size_t>(Feature::correlated) + 1;

bool has_feature(const Design& design, Feature feature);

// How a format has one of them.
enum class Holding {
    exact,   // as the program evaluates it, to rounding
    fitted,  // sampled anew, as finely as the format allows
    refused  // a design that has it is an error
};

std::string_view name_of(Holding holding);

// Of every feature. It has no default, so that no format leaves it out.
class Holdings {
  public:
    // The same of all.
    constexpr explicit Holdings(Holding all) { of_.fill(all); }

    constexpr Holdings but(Holding holding, std::initializer_list<Feature> features) const {
        Holdings result = *this;
        for (const Feature feature : features) result.of_[static_cast<std::size_t>(feature)] = holding;
        return result;
    }

    constexpr Holding operator[](Feature feature) const { return of_[static_cast<std::size_t>(feature)]; }

  private:
    std::array<Holding, feature_count> of_{};
};

}  // namespace nacre
