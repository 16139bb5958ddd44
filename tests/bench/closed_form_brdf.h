// BRDFs with closed forms, written as a renderer would: one structure of parameters, reciprocals taken once.
// All of them with Schlick's Fresnel factor in three colours. Local frame, unit vectors, 1/sr.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace nacre::bench {

using glm::vec3;

// Schlick 1994, eq. 15.
inline vec3 schlick(vec3 f0, float cosine) {
    const float m = 1 - cosine, m2 = m * m;
    return f0 + (vec3(1) - f0) * (m2 * m2 * m);
}

// Ward 1992, eq. 5, without trigonometry: Walter, "Notes on the Ward BRDF", 2005, eq. 4.
struct Ward {
    Ward(float ax, float ay, vec3 reflectance)
        : inverse_x(1 / ax),
          inverse_y(1 / ay),
          scale(1 / (4 * std::numbers::pi_v<float> * ax * ay)),
          f0(reflectance) {}

    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const vec3 h = k1 + k2;
        const float x = h.x * inverse_x, y = h.y * inverse_y;
        const float lobe = std::exp(-(x * x + y * y) / (h.z * h.z));
        const float cosine = std::min(0.5f * std::sqrt(glm::dot(h, h)), 1.0f);
        return schlick(f0, cosine) * (scale * lobe / std::sqrt(k1.z * k2.z));
    }

    float inverse_x, inverse_y, scale;
    vec3 f0;
};

// GGX with height-correlated Smith shadowing: Heitz 2014, eq. 85, 86 and 99.
struct GgxSmith {
    GgxSmith(float alpha_x, float alpha_y, vec3 reflectance)
        : ax2(alpha_x * alpha_x),
          ay2(alpha_y * alpha_y),
          inverse_x(1 / alpha_x),
          inverse_y(1 / alpha_y),
          scale(1 / (std::numbers::pi_v<float> * alpha_x * alpha_y)),
          f0(reflectance) {}

    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const vec3 sum = k1 + k2;
        const float size = std::sqrt(glm::dot(sum, sum));
        const vec3 h = sum * (1 / size);
        const float x = h.x * inverse_x, y = h.y * inverse_y;
        const float q = x * x + y * y + h.z * h.z;
        const float d = scale / (q * q);
        const float v = 0.5f / (k2.z * reach(k1) + k1.z * reach(k2));
        return schlick(f0, std::min(0.5f * size, 1.0f)) * (d * v);
    }

    float reach(vec3 k) const { return std::sqrt(ax2 * k.x * k.x + ay2 * k.y * k.y + k.z * k.z); }

    float ax2, ay2, inverse_x, inverse_y, scale;
    vec3 f0;
};

// Cook & Torrance 1982 with Beckmann facets (eq. 14) and V-groove shadowing (eq. 7), over 4 c1 c2.
struct CookTorrance {
    CookTorrance(float m, vec3 reflectance)
        : inverse_m2(1 / (m * m)), scale(1 / (4 * std::numbers::pi_v<float> * m * m)), f0(reflectance) {}

    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const vec3 sum = k1 + k2;
        const float size = std::sqrt(glm::dot(sum, sum));
        const vec3 h = sum * (1 / size);
        const float cosine = std::min(0.5f * size, 1.0f);
        const float h2 = h.z * h.z;
        const float d = scale * std::exp((h2 - 1) / h2 * inverse_m2) / (h2 * h2);
        const float g = std::min(1.0f, 2 * h.z * std::min(k1.z, k2.z) / cosine);
        return schlick(f0, cosine) * (d * g / (k1.z * k2.z));
    }

    float inverse_m2, scale;
    vec3 f0;
};

}  // namespace nacre::bench
