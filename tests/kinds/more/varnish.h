#pragma once

#include <tuple>

#include "core/model/coat/shader_coat.h"
#include "core/model/kinds/parameter.h"
#include "core/model/lobes/uniform.h"

namespace nacre {

// As even a highlight as there is: its facets stand every way.
struct VarnishCoat {
    double ior = 1.4;
    bool operator==(const VarnishCoat&) const = default;

    static constexpr const char* name = "varnish";
    static constexpr const char* label = "Varnish";
    static constexpr const char* explanation = "Dull.";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{NumberParameter<VarnishCoat>{.member = &VarnishCoat::ior,
                                                       .text = {"ior", "IOR##varnish", "Index.", "coat_ior"},
                                                       .bounds = {1.01, 2},
                                                       .slider = {.ends = {1.01, 2}}}};
    }

    static constexpr const char* formula = "D = 1/pi";
    static constexpr const char* area_formula = "gc = max(z, (1 + z)/2)";
    static constexpr bool covers = true;
    UniformLobe lobe() const { return {}; }
    ShaderCoat shader() const { return {1, ior, glm::dvec3(0)}; }
};

}  // namespace nacre
