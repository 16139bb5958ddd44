#include "core/model/pyramid_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/model/pyramid_kernel.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 4>;
using Floats = hn::Rebind<float, Doubles>;
using Vector = hn::Vec<Doubles>;
using LongDoubles = hn::CappedTag<double, 8>;  // for the leaves
using LongVector = hn::Vec<LongDoubles>;

// A cell wholly in front of k adds k.m, one wholly behind nothing, and only the cells that the great circle
// h.k = 0 passes are opened (docs/mathematics.md, sec. 10). Breadth first, and without a branch on what is
// opened.
template <bool with_gradient>
class Walk {
  public:
    explicit Walk(dvec3 k) : k_(k), x_(hn::Set(d_, k.x)), y_(hn::Set(d_, k.y)), z_(hn::Set(d_, k.z)) {}

    // Adds the children that k sees whole and lists those to be opened, `first` being the first one's name.
    std::size_t add(const BallBlock& balls, const MomentBlock& moments, std::size_t first,
                    std::size_t* HWY_RESTRICT open, std::size_t count) {
        const Floats f;
        unsigned crossed = 0;
        for (std::size_t i = 0; i < 4; i += hn::Lanes(d_)) {
            const Vector distance =
                hn::MulAdd(hn::PromoteTo(d_, hn::LoadU(f, balls.x + i)), x_,
                           hn::MulAdd(hn::PromoteTo(d_, hn::LoadU(f, balls.y + i)), y_,
                                      hn::Mul(hn::PromoteTo(d_, hn::LoadU(f, balls.z + i)), z_)));
            const Vector radius = hn::PromoteTo(d_, hn::LoadU(f, balls.radius + i));
            const auto front = hn::Ge(distance, radius);
            const Vector x = hn::IfThenElseZero(front, hn::LoadU(d_, moments.x + i));
            const Vector y = hn::IfThenElseZero(front, hn::LoadU(d_, moments.y + i));
            const Vector z = hn::IfThenElseZero(front, hn::LoadU(d_, moments.z + i));
            g_ = hn::Add(g_, hn::MulAdd(x, x_, hn::MulAdd(y, y_, hn::Mul(z, z_))));
            if constexpr (with_gradient) {
                gx_ = hn::Add(gx_, x);
                gy_ = hn::Add(gy_, y);
                gz_ = hn::Add(gz_, z);
            }
            alignas(8) std::uint8_t byte[8] = {};
            hn::StoreMaskBits(d_, hn::AndNot(front, hn::Gt(distance, hn::Neg(radius))), byte);
            crossed |= static_cast<unsigned>(byte[0]) << i;
        }
        for (std::size_t j = 0; j < 4; ++j) {
            open[count] = first + j;
            count += (crossed >> j) & 1;
        }
        return count;
    }

    // A node of a tile and all that lies beneath it.
    void add(const PyramidTile& tile, std::size_t node) {
        const std::size_t inner = tile.balls.size();
        std::size_t open[tile_nodes_max + 4];
        std::size_t count = 1, next = 0;
        open[0] = node;
        for (; next < count && open[next] < inner; ++next) {
            const std::size_t i = open[next];
            count = add(tile.balls[i], tile.moments[i], 4 * i + 1, open, count);
        }
        for (; next < count; ++next) add(tile.leaves[open[next] - inner]);
    }

    double area() const {
        const LongDoubles d;
        return std::max(hn::GetLane(hn::SumOfLanes(d_, g_)) + hn::GetLane(hn::SumOfLanes(d, leaf_g_)), 0.0);
    }

    dvec3 gradient() const {
        const LongDoubles d;
        return {hn::GetLane(hn::SumOfLanes(d_, gx_)) + hn::GetLane(hn::SumOfLanes(d, leaf_x_)) + bent_.x,
                hn::GetLane(hn::SumOfLanes(d_, gy_)) + hn::GetLane(hn::SumOfLanes(d, leaf_y_)) + bent_.y,
                hn::GetLane(hn::SumOfLanes(d_, gz_)) + hn::GetLane(hn::SumOfLanes(d, leaf_z_)) + bent_.z};
    }

  private:
    // What k sees of a tent of half-width a about m: m + (a - |m|)^3/(6 a^2) where that is less than a from
    // 0.
    void add(const LeafBlock& leaf) {
        const LongDoubles d;
        const Spread& s = leaf.spread;
        const dvec3 along(s.xx * k_.x + s.xy * k_.y + s.xz * k_.z, s.xy * k_.x + s.yy * k_.y + s.yz * k_.z,
                          s.xz * k_.x + s.yz * k_.y + s.zz * k_.z);
        const double square = std::max(glm::dot(k_, along), 0.0);
        const LongVector zero = hn::Zero(d), width = hn::Set(d, std::sqrt(square));
        LongVector bent = zero;
        for (std::size_t i = 0; i < 16; i += hn::Lanes(d)) {
            const LongVector x = hn::LoadU(d, leaf.x + i), y = hn::LoadU(d, leaf.y + i),
                             z = hn::LoadU(d, leaf.z + i);
            const LongVector seen = hn::MulAdd(x, hn::Set(d, k_.x),
                                               hn::MulAdd(y, hn::Set(d, k_.y), hn::Mul(z, hn::Set(d, k_.z))));
            const LongVector a = hn::Mul(hn::LoadU(d, leaf.share + i), width);
            const LongVector rest = hn::Max(hn::Sub(a, hn::Abs(seen)), zero);
            const LongVector part = hn::Div(rest, hn::Max(a, hn::Set(d, smallest)));  // 0 to 1
            const LongVector tip = hn::Mul(hn::Mul(rest, hn::Set(d, 1.0 / 6)), hn::Mul(part, part));
            leaf_g_ = hn::Add(leaf_g_, hn::Add(hn::Max(seen, zero), tip));
            if constexpr (with_gradient) {
                const LongVector back = hn::Mul(hn::Set(d, 0.5), hn::Mul(part, part));
                const LongVector front =
                    hn::IfThenElse(hn::Gt(seen, zero), hn::Sub(hn::Set(d, 1.0), back), back);
                leaf_x_ = hn::MulAdd(front, x, leaf_x_);
                leaf_y_ = hn::MulAdd(front, y, leaf_y_);
                leaf_z_ = hn::MulAdd(front, z, leaf_z_);
                bent = hn::Add(bent, hn::Sub(hn::Add(hn::Max(seen, zero), tip), hn::Mul(front, seen)));
            }
        }
        if (with_gradient && square > 0) bent_ += along * (hn::GetLane(hn::SumOfLanes(d, bent)) / square);
    }

    static constexpr double smallest = std::numeric_limits<double>::min();

    dvec3 k_;
    Doubles d_;
    Vector x_, y_, z_;
    Vector g_ = hn::Zero(d_), gx_ = hn::Zero(d_), gy_ = hn::Zero(d_), gz_ = hn::Zero(d_);
    LongVector leaf_g_ = hn::Zero(LongDoubles()), leaf_x_ = hn::Zero(LongDoubles()),
               leaf_y_ = hn::Zero(LongDoubles()), leaf_z_ = hn::Zero(LongDoubles());
    dvec3 bent_{0};  // by the tents' spread
};

template <bool with_gradient>
Walk<with_gradient> walk(const PyramidTop& top, dvec3 k) {
    Walk<with_gradient> result(k);
    std::size_t open[8];
    for (std::size_t i = 0; i < top.balls.size(); ++i) {
        const std::size_t count = result.add(top.balls[i], top.moments[i], 4 * i, open, 0);
        for (std::size_t j = 0; j < count; ++j) result.add(*top.tiles[open[j]], 0);
    }
    return result;
}

double area_of_top(const PyramidTop& top, dvec3 k) { return walk<false>(top, k).area(); }

Area area_and_gradient_of_top(const PyramidTop& top, dvec3 k) {
    const Walk<true> result = walk<true>(top, k);
    return {result.area(), result.gradient()};
}

double area_of_node(const PyramidTile& tile, std::size_t node, dvec3 k) {
    Walk<false> result(k);
    result.add(tile, node);
    return result.area();
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(area_of_top);
HWY_EXPORT(area_and_gradient_of_top);
HWY_EXPORT(area_of_node);

double sum_visible_area(const PyramidTop& top, dvec3 k) { return HWY_DYNAMIC_DISPATCH(area_of_top)(top, k); }

Area sum_visible(const PyramidTop& top, dvec3 k) {
    return HWY_DYNAMIC_DISPATCH(area_and_gradient_of_top)(top, k);
}

double sum_visible_area(const PyramidTile& tile, std::size_t node, dvec3 k) {
    return HWY_DYNAMIC_DISPATCH(area_of_node)(tile, node, k);
}

}  // namespace nacre
#endif
