// The shader's own mathematics for as many directions at once as a vector of the processor holds. For files
// that Highway compiles once for each kind of processor: everything is in HWY_NAMESPACE.
#if defined(NACRE_LANE_SHADING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_LANE_SHADING_INL_H
#undef NACRE_LANE_SHADING_INL_H
#else
#define NACRE_LANE_SHADING_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>
#include <numbers>
#include <type_traits>

#include "core/model/parameter_fields.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using glm::sqrt;

// A comparison's outcome in every lane.
template <class D>
struct LaneMask {
    hn::Mask<D> m;

    HWY_ATTR friend LaneMask operator&&(LaneMask a, LaneMask b) { return {hn::And(a.m, b.m)}; }
    HWY_ATTR friend LaneMask operator||(LaneMask a, LaneMask b) { return {hn::Or(a.m, b.m)}; }
    HWY_ATTR friend LaneMask operator&&(bool a, LaneMask b) { return a ? b : LaneMask{hn::FirstN(D(), 0)}; }
    HWY_ATTR friend bool none(LaneMask a) { return hn::AllFalse(D(), a.m); }
};

// Whole numbers beside lanes of D: exact as doubles where D holds those.
template <class D>
struct LaneIntegers;

template <class D>
struct LaneReals {
    using Number = hn::TFromD<D>;
    hn::Vec<D> v;

    LaneReals() = default;  // holds anything, as in GLSL
    HWY_ATTR explicit LaneReals(hn::Vec<D> lanes) : v(lanes) {}
    template <class Scalar, std::enable_if_t<std::is_arithmetic_v<Scalar>, int> = 0>
    HWY_ATTR LaneReals(Scalar all) : v(hn::Set(D(), static_cast<Number>(all))) {}
    HWY_ATTR explicit LaneReals(LaneIntegers<D> integers);

    HWY_ATTR friend LaneReals operator+(LaneReals a, LaneReals b) { return LaneReals(hn::Add(a.v, b.v)); }
    HWY_ATTR friend LaneReals operator-(LaneReals a, LaneReals b) { return LaneReals(hn::Sub(a.v, b.v)); }
    HWY_ATTR friend LaneReals operator*(LaneReals a, LaneReals b) { return LaneReals(hn::Mul(a.v, b.v)); }
    HWY_ATTR friend LaneReals operator/(LaneReals a, LaneReals b) { return LaneReals(hn::Div(a.v, b.v)); }
    HWY_ATTR friend LaneReals operator-(LaneReals a) { return LaneReals(hn::Neg(a.v)); }
    HWY_ATTR LaneReals& operator+=(LaneReals b) { return *this = *this + b; }
    HWY_ATTR LaneReals& operator*=(LaneReals b) { return *this = *this * b; }

    HWY_ATTR friend LaneMask<D> operator<(LaneReals a, LaneReals b) { return {hn::Lt(a.v, b.v)}; }
    HWY_ATTR friend LaneMask<D> operator<=(LaneReals a, LaneReals b) { return {hn::Le(a.v, b.v)}; }
    HWY_ATTR friend LaneMask<D> operator>(LaneReals a, LaneReals b) { return {hn::Gt(a.v, b.v)}; }
    HWY_ATTR friend LaneMask<D> operator>=(LaneReals a, LaneReals b) { return {hn::Ge(a.v, b.v)}; }
    HWY_ATTR friend LaneMask<D> operator==(LaneReals a, LaneReals b) { return {hn::Eq(a.v, b.v)}; }

    HWY_ATTR friend LaneReals select(LaneMask<D> c, LaneReals yes, LaneReals no) {
        return LaneReals(hn::IfThenElse(c.m, yes.v, no.v));
    }
    HWY_ATTR friend LaneReals abs(LaneReals a) { return LaneReals(hn::Abs(a.v)); }
    HWY_ATTR friend LaneReals sqrt(LaneReals a) { return LaneReals(hn::Sqrt(a.v)); }
    HWY_ATTR friend LaneReals exp(LaneReals a) { return LaneReals(hn::Exp(D(), a.v)); }
    // Turned round, so that a NaN in `a` stays NaN, as in glm.
    HWY_ATTR friend LaneReals min(LaneReals a, LaneReals b) { return LaneReals(hn::Min(b.v, a.v)); }
    HWY_ATTR friend LaneReals max(LaneReals a, LaneReals b) { return LaneReals(hn::Max(b.v, a.v)); }
    HWY_ATTR friend LaneReals clamp(LaneReals a, LaneReals low, LaneReals high) {
        return min(max(a, low), high);
    }

    // Of the smaller over the larger, so that nothing overflows; (0, 0) has no angle, as in GLSL.
    HWY_ATTR friend LaneReals atan(LaneReals y, LaneReals x) {
        const LaneReals across = abs(y), along = abs(x), quarter(0.5 * std::numbers::pi);
        const LaneMask<D> steep = along < across;
        const LaneReals slope = select(steep, along, across) / select(steep, across, along);
        LaneReals angle(hn::Atan(D(), slope.v));
        angle = select(steep, quarter - angle, angle);
        angle = select(x < LaneReals(0.0), LaneReals(std::numbers::pi) - angle, angle);
        return LaneReals(hn::CopySign(angle.v, y.v));
    }
};

template <class D>
struct LaneIntegers {
    using Number = hn::TFromD<D>;
    static constexpr bool in_floats = std::is_same_v<Number, float>;
    using I = std::conditional_t<in_floats, hn::RebindToSigned<D>, D>;
    hn::Vec<I> v;

    LaneIntegers() = default;
    HWY_ATTR explicit LaneIntegers(hn::Vec<I> lanes) : v(lanes) {}
    HWY_ATTR LaneIntegers(int all) : v(hn::Set(I(), static_cast<hn::TFromD<I>>(all))) {}

    // Toward 0.
    HWY_ATTR explicit LaneIntegers(LaneReals<D> a) {
        if constexpr (in_floats) {
            v = hn::ConvertTo(I(), a.v);
        } else {
            v = hn::Trunc(a.v);
        }
    }

    HWY_ATTR friend LaneIntegers operator+(LaneIntegers a, LaneIntegers b) {
        return LaneIntegers(hn::Add(a.v, b.v));
    }
    HWY_ATTR friend LaneIntegers operator*(LaneIntegers a, LaneIntegers b) {
        return LaneIntegers(hn::Mul(a.v, b.v));
    }
    HWY_ATTR friend LaneIntegers min(LaneIntegers a, LaneIntegers b) {
        return LaneIntegers(hn::Min(a.v, b.v));
    }
    HWY_ATTR friend LaneMask<I> operator==(LaneIntegers a, LaneIntegers b) { return {hn::Eq(a.v, b.v)}; }

    template <class Mask>
    HWY_ATTR friend LaneIntegers select(LaneMask<Mask> c, LaneIntegers yes, LaneIntegers no) {
        return LaneIntegers(hn::IfThenElse(hn::RebindMask(I(), c.m), yes.v, no.v));
    }
};

template <class D>
HWY_ATTR LaneReals<D>::LaneReals(LaneIntegers<D> integers) {
    if constexpr (LaneIntegers<D>::in_floats) {
        v = hn::ConvertTo(D(), integers.v);
    } else {
        v = integers.v;
    }
}

// data[at] in every lane.
template <class D>
LaneReals<D> gather(const float* data, LaneIntegers<D> at) {
    if constexpr (LaneIntegers<D>::in_floats) {
        return LaneReals<D>(hn::GatherIndex(D(), data, at.v));
    } else {
        const hn::Rebind<std::int32_t, D> integers;
        const hn::Rebind<float, D> floats;
        return LaneReals<D>(hn::PromoteTo(D(), hn::GatherIndex(floats, data, hn::DemoteTo(integers, at.v))));
    }
}

template <class D>
struct LaneReals2 {
    LaneReals<D> x, y;

    LaneReals2() = default;
    HWY_ATTR LaneReals2(LaneReals<D> a, LaneReals<D> b) : x(a), y(b) {}

    HWY_ATTR friend LaneReals<D> length(LaneReals2 a) { return sqrt(a.x * a.x + a.y * a.y); }
};

template <class D>
struct LaneReals3 {
    using Real = LaneReals<D>;
    Real x, y, z;

    LaneReals3() = default;
    HWY_ATTR explicit LaneReals3(Real all) : x(all), y(all), z(all) {}
    HWY_ATTR LaneReals3(Real a, Real b, Real c) : x(a), y(b), z(c) {}
    HWY_ATTR LaneReals3(glm::vec<3, hn::TFromD<D>> all) : x(all.x), y(all.y), z(all.z) {}

    HWY_ATTR friend LaneReals3 operator+(LaneReals3 a, LaneReals3 b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    HWY_ATTR friend LaneReals3 operator-(LaneReals3 a, LaneReals3 b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    HWY_ATTR friend LaneReals3 operator*(LaneReals3 a, LaneReals3 b) {
        return {a.x * b.x, a.y * b.y, a.z * b.z};
    }
    HWY_ATTR friend LaneReals3 operator*(LaneReals3 a, Real b) { return {a.x * b, a.y * b, a.z * b}; }
    HWY_ATTR friend LaneReals3 operator/(LaneReals3 a, Real b) { return {a.x / b, a.y / b, a.z / b}; }
    HWY_ATTR LaneReals3& operator+=(LaneReals3 b) { return *this = *this + b; }

    HWY_ATTR friend LaneReals3 select(LaneMask<D> c, LaneReals3 yes, LaneReals3 no) {
        return {select(c, yes.x, no.x), select(c, yes.y, no.y), select(c, yes.z, no.z)};
    }
    HWY_ATTR friend LaneReals3 max(LaneReals3 a, LaneReals3 b) {
        return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
    }
    HWY_ATTR friend Real dot(LaneReals3 a, LaneReals3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    HWY_ATTR friend Real length(LaneReals3 a) { return sqrt(dot(a, a)); }
};

template <class D>
struct LaneShading {
    using scalar = hn::TFromD<D>;
    using scalar2 = glm::vec<2, scalar>;
    using scalar3 = glm::vec<3, scalar>;
    using real = LaneReals<D>;
    using real2 = LaneReals2<D>;
    using real3 = LaneReals3<D>;
    using integer = LaneIntegers<D>;
    using condition = LaneMask<D>;

    real fetch(integer index) const { return gather<D>(data, index); }
    real fetch_curve(integer index) const { return gather<D>(curve, index); }

#include "core/model/shading_members.inl"
};

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
