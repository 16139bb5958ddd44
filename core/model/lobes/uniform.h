#pragma once

#include <memory>
#include <tuple>

#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;

enum class UniformDomain { hemisphere, sphere };

struct UniformLobe {
    UniformDomain domain = UniformDomain::hemisphere;
    bool operator==(const UniformLobe&) const = default;

    static constexpr const char* name = "uniform";
    static constexpr const char* label = "Uniform";
    static constexpr const char* explanation =
        "Facets look everywhere equally: matt, like pressed powder.\n"
        "p = 1/(2\u03c0) over the hemisphere, 1/(4\u03c0) over the sphere";
    static constexpr auto parameters() {
        return std::tuple{ChoiceParameter<UniformLobe, UniformDomain, 2>{
            .member = &UniformLobe::domain,
            .text = {"domain", "Facets over",
                     "The upper hemisphere, or the whole sphere as for grains and fibres. A whole "
                     "sphere alone has no mean normal, so it needs another layer beside it."},
            .names = {"hemisphere", "sphere"},
            .labels = {"Hemisphere", "Whole sphere"}}};
    }

    static constexpr WidthMembers<UniformLobe> width_members{};
    static UniformLobe of_widths(glm::dvec2) { return {}; }

    double period() const { return 0; }
    ExtremeClaims extreme_claims() const {
        if (domain == UniformDomain::sphere) return {.refusal = "the facets must face up on the whole"};
        return {};
    }
    bool reaches_below() const { return domain == UniformDomain::sphere; }
    const char* table_kind() const { return domain == UniformDomain::sphere ? "sphere" : "hemisphere"; }
    const char* formula() const { return domain == UniformDomain::sphere ? "1, also where z <= 0" : "1"; }
    ShaderLobe shader() const { return {.data_size = domain == UniformDomain::sphere ? 1 : 0}; }
    std::shared_ptr<const LobeModel> model() const;
};

}  // namespace nacre
