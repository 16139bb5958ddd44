#include "core/paint/stroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/paint/painted_layer.h"

namespace nacre {
namespace {

constexpr double spacing = 0.2;  // of the radius

}  // namespace

Stroke::Stroke(const Raster& before, StrokeStyle style, dvec3 at)
    : working_(before),
      style_(std::move(style)),
      scratch_(before.width),
      at_(above_horizon(at)),
      last_dab_(at_) {
    to_next_ = spacing * style_.brush.radius * (std::numbers::pi / 180);
    if (style_.tool != PaintTool::smear) dab(at_, at_);
}

void Stroke::dab(dvec3 at, dvec3 from) {
    apply_dab(working_,
              {.tool = style_.tool,
               .brush = style_.brush,
               .symmetry = style_.symmetry,
               .at = at,
               .from = from,
               .tip = style_.tip.get()},
              scratch_);
    last_dab_ = at;
    published_.reset();
}

void Stroke::move_to(dvec3 to) {
    to = above_horizon(to);
    if (style_.tool == PaintTool::stamp) return;
    const dvec3 begin = at_;
    const double way = angle_between(begin, to);
    if (!(way > 0) || way > std::numbers::pi - 1e-6) return;
    const dvec3 across = glm::normalize(to - begin * glm::dot(begin, to));
    const double step = spacing * style_.brush.radius * (std::numbers::pi / 180);
    double gone = to_next_;
    for (; gone <= way; gone += step) dab(begin * std::cos(gone) + across * std::sin(gone), last_dab_);
    to_next_ = gone - way;
    at_ = to;
}

std::shared_ptr<const Raster> Stroke::raster() {
    if (!published_) published_ = std::make_shared<const Raster>(working_);
    return published_;
}

}  // namespace nacre
