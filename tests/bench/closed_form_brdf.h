// The closed forms of shaders/shared/closed_forms.glsl as a renderer would call them, in float: reciprocals
// taken once. All of them with Schlick's Fresnel factor in three colours. Local frame, unit vectors, 1/sr.
#pragma once

#include <numbers>

#include "core/model/shading.h"

namespace nacre::bench {

using glm::vec3;
using Shader = Shading<float>;

inline Shader::ClosedForm closed_form(float alpha_x, float alpha_y) {
    Shader::ClosedForm form{};
    form.axis = {1, 0};
    form.width = {alpha_x, alpha_y};
    form.inverse_width = 1.0f / form.width;
    form.scale = 1 / (std::numbers::pi_v<float> * alpha_x * alpha_y);
    return form;
}

struct Ward {
    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const float cosine = glm::min(0.5f * glm::length(k1 + k2), 1.0f);
        return Shader::schlick_fresnel(f0, vec3(0), cosine) * Shader::ward(form, k1, k2);
    }

    Shader::ClosedForm form;
    vec3 f0;
};

struct GgxSmith {
    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const vec3 sum = k1 + k2;
        const float size = glm::length(sum);
        return Shader::schlick_fresnel(f0, vec3(0), glm::min(0.5f * size, 1.0f)) *
               Shader::ggx(form, k1, k2, sum * (1 / size));
    }

    Shader::ClosedForm form;
    vec3 f0;
};

struct CookTorrance {
    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const vec3 sum = k1 + k2;
        const float size = glm::length(sum), cosine = glm::min(0.5f * size, 1.0f);
        return Shader::schlick_fresnel(f0, vec3(0), cosine) *
               Shader::cook_torrance(form, k1, k2, sum * (1 / size), cosine);
    }

    Shader::ClosedForm form;
    vec3 f0;
};

}  // namespace nacre::bench
