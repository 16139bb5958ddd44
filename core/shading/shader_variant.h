// A shader variant as a value, turned into GLSL text by a pure function: it holds only what its design and
// its scene need.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/model/shading.h"
#include "core/shading/term.h"

namespace nacre {

struct ShaderVariant {
    std::set<int> lobes;  // in use, by their place in Lobe
    bool modulation = false;
    ShadingKinds kinds;
    int lights = 1;
    bool ambient = false;
    bool environment_behind = false;      // an environment is drawn behind the object
    Term term = Term::total;              // what of the BRDF the picture shows
    std::optional<int> closed_form = {};  // MODEL_* in place of the design's own BRDF

    bool operator==(const ShaderVariant&) const = default;
};

ShaderVariant variant_of(const Shading<double>& shading);

// The preprocessor definitions of the variant, without #version.
std::string variant_definitions(const ShaderVariant& variant);

// The shared mathematics, in order: what comes before `fetch` is defined, and what comes after.
std::string shared_parameters(const ShaderVariant& variant);
std::string shared_mathematics(const ShaderVariant& variant);

// A whole fragment shader, GLSL 3.30 core; `main` names a file of shaders/, for instance "surface.frag".
std::string fragment_shader(const ShaderVariant& variant, std::string_view main);

}  // namespace nacre
