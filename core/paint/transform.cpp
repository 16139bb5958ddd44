#include "core/paint/transform.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

constexpr double margin = 8e-3;  // about what is carried, so that its soft rim is carried too

struct Bounds {
    dvec2 low{HUGE_VAL}, high{-HUGE_VAL};

    void include(dvec2 at) { low = glm::min(low, at), high = glm::max(high, at); }
    bool holds_any() const { return low.x <= high.x; }
};

}  // namespace

std::optional<Transform> Transform::of(std::shared_ptr<const Raster> before, const glm::dmat3& layer_frame,
                                       const std::shared_ptr<const TexelShares>& selected) {
    Transform transform;
    const std::size_t count = before->values.size();
    transform.shares_.resize(count);
    transform.part_.resize(count);
    transform.rest_ = before->values;
    transform.places_.resize(count);
    transform.frame_ = layer_frame;
    Bounds paint, all;
    visit_texels(before->width, {0, 0, 1}, std::numbers::pi, [&](std::size_t index, dvec3 h) {
        const dvec2 place = transform.places_[index] = disk_point(layer_frame * h);
        const float share = transform.shares_[index] = selected ? (*selected)[index] : 1;
        transform.part_[index] = before->values[index] * share;
        transform.rest_[index] = before->values[index] * (1 - share);
        if (!(share > 0)) return;
        all.include(place);
        if (before->values[index] > 0) paint.include(place);
    });
    const Bounds& bounds = paint.holds_any() ? paint : all;
    if (!bounds.holds_any() || (!selected && !paint.holds_any())) return {};
    transform.before_ = std::move(before);
    const dvec2 half = 0.5 * (bounds.high - bounds.low) + margin;
    transform.box_ = {0.5 * (bounds.low + bounds.high), {half.x, 0}, {0, half.y}};
    return transform;
}

std::shared_ptr<const Raster> Transform::carried(const DiskBox& to, Blend blend) const {
    if (to == box_) return before_;
    const int side = before_->width;
    auto raster = std::make_shared<Raster>(Raster{side, side, rest_});
    const glm::dmat2 back = glm::inverse(glm::dmat2(to.right, to.up));
    const glm::dmat3 to_layer = glm::transpose(frame_);
    Brush brush{.blend = blend};
    visit_texels(side, {0, 0, 1}, std::numbers::pi, [&](std::size_t index, dvec3) {
        const dvec2 own = back * (places_[index] - to.middle);
        if (std::max(std::abs(own.x), std::abs(own.y)) > 1) return;
        const dvec2 source = box_.at(own);
        if (!(glm::dot(source, source) < 2)) return;
        const dvec2 from = disk_point(to_layer * disk_direction(source));
        const double share = raster_value(shares_, side, from);
        if (!(share > 0)) return;
        brush.value = raster_value(part_, side, from) / share;
        raster->values[index] = static_cast<float>(painted(brush, static_cast<double>(rest_[index]), share));
    });
    return raster;
}

}  // namespace nacre
