// The shader's own mathematics as C++: shaders/shared/*.glsl compiled in float (what a GPU computes) and in
// double. The texts are the single place where lobes, Fresnel, tables and the BRDF are written;
// lane_shading-inl.h compiles them for many directions at once.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <memory>

#include "core/base/limits.h"
#include "core/model/coat_models.h"
#include "core/model/diffuse_models.h"
#include "core/model/fresnel_models.h"
#include "core/model/lobes.h"
#include "core/model/masking_models.h"
#include "core/model/multibounce_models.h"
#include "core/model/tint.h"

namespace nacre {

// What a shader variant fixes at compile time and C++ decides at run time. Models are indices into
// the alternatives of Fresnel, MaskingModel, Diffuse, Multibounce and Coat.
struct ShadingKinds {
    int fresnel = kind_index<Fresnel, NoFresnel>();
    int masking = kind_index<MaskingModel, UncorrelatedMasking>();
    int diffuse = kind_index<Diffuse, NoDiffuse>();
    int multibounce = kind_index<Multibounce, NoMultibounce>();  // whose tables there are
    bool clamp = true;
    bool albedo = false;  // the tables hold R
    Tint tint = Tint::none;
    bool retro = false;  // surface.retro is above 0
    int coat = kind_index<Coat, NoCoat>();

    constexpr FresnelTables fresnel_tables() const {
        return nacre::fresnel_tables(static_cast<std::size_t>(fresnel));
    }
    constexpr bool fresnel_is_curve() const {
        return nacre::fresnel_is_curve(static_cast<std::size_t>(fresnel));
    }
    constexpr bool matt_facets() const { return has_matt_facets(static_cast<std::size_t>(diffuse)); }
    constexpr bool coated() const { return is_coated(static_cast<std::size_t>(coat)); }
    constexpr bool bounces() const { return has_bounces(static_cast<std::size_t>(multibounce)); }
    // Tables of what light meets that bounces on: none with F = 1, one for Schlick's weight, else one a
    // colour.
    constexpr int bounce_factors() const {
        if (tint == Tint::varied || fresnel_tables() == FresnelTables::exact) return 3;
        return fresnel_tables() == FresnelTables::linear ? 1 : 0;
    }
    constexpr MaskingBends masking_bends() const {
        return nacre::masking_bends(static_cast<std::size_t>(masking));
    }

    bool operator==(const ShadingKinds&) const = default;
};

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

template <class Value>
Value select(bool condition, const Value& yes, const Value& no) {
    return condition ? yes : no;
}

inline bool none(bool condition) { return !condition; }

template <class Real>
struct Shading {
    using scalar = Real;
    using scalar2 = glm::vec<2, Real>;
    using scalar3 = glm::vec<3, Real>;
    using real = scalar;
    using real2 = scalar2;
    using real3 = scalar3;
    using integer = int;
    using condition = bool;

    real fetch(integer index) const { return static_cast<real>(data[index]); }
    real fetch_curve(integer index) const { return static_cast<real>(curve[index]); }

#include "core/model/shading_members.inl"

    std::shared_ptr<const FresnelCurve> fresnel_curve;  // what `curve` points into
};

}  // namespace shading_detail

template <class Real>
using Shading = shading_detail::Shading<Real>;

}  // namespace nacre
