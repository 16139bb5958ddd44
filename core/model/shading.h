// The shader's own mathematics as C++: shaders/shared/*.glsl compiled in float (what a GPU computes) and in
// double. The texts are the single place where lobes, Fresnel, tables and the BRDF are written.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "core/design/design.h"

namespace nacre {

enum class FresnelKind { none, schlick, dielectric, conductor };
enum class VisibilityKind { uncorrelated, correlated, smith_correlated };
enum class DiffuseKind { none, lambertian, coupled, metal };

// What a shader variant fixes at compile time and C++ decides at run time.
struct ShadingKinds {
    FresnelKind fresnel = FresnelKind::none;
    VisibilityKind visibility = VisibilityKind::uncorrelated;
    DiffuseKind diffuse = DiffuseKind::none;
    bool clamp = true;
    bool albedo = false;  // the tables hold R

    bool operator==(const ShadingKinds&) const = default;
};

#define CONSTANT static constexpr
#define PURE static
#define READS const
#define HAS_GAUSSIAN 1
#define HAS_INVERSE_GAUSSIAN 1
#define HAS_GGX 1
#define HAS_BECKMANN 1
#define HAS_UNIFORM 1
#define HAS_CURVE 1
#define HAS_PAINTED 1
#define HAS_MODULATION 1
#define HAS_ALBEDO 1
#define FRESNEL_SCHLICK 1
#define FRESNEL_DIELECTRIC 1
#define FRESNEL_CONDUCTOR 1
#define VISIBILITY_CORRELATED 1
#define VISIBILITY_SMITH 1
#define DIFFUSE_LAMBERTIAN 1
#define DIFFUSE_COUPLED 1
#define DIFFUSE_METAL 1
#define FRESNEL_IS_SCHLICK kinds.fresnel == FresnelKind::schlick
#define FRESNEL_IS_DIELECTRIC kinds.fresnel == FresnelKind::dielectric
#define FRESNEL_IS_CONDUCTOR kinds.fresnel == FresnelKind::conductor
#define VISIBILITY_IS_CORRELATED kinds.visibility == VisibilityKind::correlated
#define VISIBILITY_IS_SMITH kinds.visibility == VisibilityKind::smith_correlated
#define CLAMP_VISIBILITY kinds.clamp
#define DIFFUSE_IS_LAMBERTIAN kinds.diffuse == DiffuseKind::lambertian
#define DIFFUSE_IS_COUPLED kinds.diffuse == DiffuseKind::coupled
#define DIFFUSE_IS_METAL kinds.diffuse == DiffuseKind::metal
#define READS_ALBEDO kinds.albedo

namespace shading_detail {

inline float abs(float x) { return std::fabs(x); }
inline double abs(double x) { return std::fabs(x); }

using glm::atan;
using glm::clamp;
using glm::dot;
using glm::exp;
using glm::length;
using glm::max;
using glm::min;
using glm::sqrt;

template <class Real>
struct Shading {
    using real = Real;
    using real2 = glm::vec<2, Real>;
    using real3 = glm::vec<3, Real>;
    static constexpr real LARGEST = std::numeric_limits<Real>::max();

#include "shaders/shared/parameters.glsl"

    ShadingKinds kinds;
    Surface surface{};
    Layer layers[limits::layers_max]{};
    int layer_count = 0;
    const float* data = nullptr;  // tables, curves and pictures; owned by the Tables this was made from

    real fetch(int index) const { return static_cast<real>(data[index]); }

#include "shaders/shared/fresnel.glsl"
#include "shaders/shared/lobes.glsl"
#include "shaders/shared/tables.glsl"

#include "shaders/shared/brdf.glsl"
};

}  // namespace shading_detail

template <class Real>
using Shading = shading_detail::Shading<Real>;

#undef CONSTANT
#undef PURE
#undef READS
#undef HAS_GAUSSIAN
#undef HAS_INVERSE_GAUSSIAN
#undef HAS_GGX
#undef HAS_BECKMANN
#undef HAS_UNIFORM
#undef HAS_CURVE
#undef HAS_PAINTED
#undef HAS_MODULATION
#undef HAS_ALBEDO
#undef FRESNEL_SCHLICK
#undef FRESNEL_DIELECTRIC
#undef FRESNEL_CONDUCTOR
#undef VISIBILITY_CORRELATED
#undef VISIBILITY_SMITH
#undef DIFFUSE_LAMBERTIAN
#undef DIFFUSE_COUPLED
#undef DIFFUSE_METAL
#undef FRESNEL_IS_SCHLICK
#undef FRESNEL_IS_DIELECTRIC
#undef FRESNEL_IS_CONDUCTOR
#undef VISIBILITY_IS_CORRELATED
#undef VISIBILITY_IS_SMITH
#undef CLAMP_VISIBILITY
#undef DIFFUSE_IS_LAMBERTIAN
#undef DIFFUSE_IS_COUPLED
#undef DIFFUSE_IS_METAL
#undef READS_ALBEDO

}  // namespace nacre
