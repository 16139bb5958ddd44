#include "core/paint/stroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/paint/painted_layer.h"

namespace nacre {
namespace {

// Between two dabs, radians.
double spacing(const Brush& brush) {
    return std::clamp(brush.spacing, spacing_min, spacing_max) * brush.radius * (std::numbers::pi / 180);
}

const DabTool* dab_tool(PaintTool tool) { return std::get_if<DabTool>(&info(tool).work); }

}  // namespace

Stroke::Stroke(const Raster& before, StrokeStyle style, dvec3 at, const Touch& touch)
    : working_(before),
      style_(std::move(style)),
      scratch_(before.width),
      begin_(above_horizon(at)),
      at_(begin_),
      touch_(touch),
      last_dab_(begin_),
      to_next_(spacing(touched(style_.brush, touch))) {
    if (style_.brush.opacity < 1 || style_.selected) before_ = before.values;
    if (const auto* area = std::get_if<AreaTool>(&info(style_.tool).work)) cover_area(*area);
    const DabTool* dabs = dab_tool(style_.tool);
    if (dabs != nullptr && dabs->at_press) dab(at_, at_, touch);
}

void Stroke::cover_area(const AreaTool& tool) {
    tool.cover(working_,
               {.symmetry = style_.symmetry,
                .at = at_,
                .tolerance = style_.tolerance,
                .selected = style_.selected.get()},
               scratch_);
    scratch_.paint(working_.values, style_.brush);
}

void Stroke::dab(dvec3 at, dvec3 from, const Touch& touch) {
    dab_tool(style_.tool)
        ->dab(working_,
              {.brush = touched(style_.brush, touch),
               .symmetry = style_.symmetry,
               .at = at,
               .from = from,
               .tip = style_.tip.get(),
               .to_tip = style_.to_tip},
              scratch_);
    last_dab_ = at;
    published_.reset();
}

void Stroke::dabs_to(dvec3 to, const Touch& touch) {
    const dvec3 begin = at_;
    const double way = angle_between(begin, to);
    if (!(way > 0) || way > std::numbers::pi - 1e-6) return;
    const dvec3 across = glm::normalize(to - begin * glm::dot(begin, to));
    double gone = to_next_;
    while (gone <= way) {
        const Touch now = between(touch_, touch, gone / way);
        dab(begin * std::cos(gone) + across * std::sin(gone), last_dab_, now);
        gone += spacing(touched(style_.brush, now));
    }
    to_next_ = gone - way;
    at_ = to;
    touch_ = touch;
}

void Stroke::move_to(dvec3 to, const Touch& touch) {
    to = above_horizon(to);
    if (const DabTool* dabs = dab_tool(style_.tool)) {
        if (dabs->follows_way) dabs_to(to, touch);
    } else if (to != at_ && !std::holds_alternative<AreaTool>(info(style_.tool).work)) {
        at_ = to;
        published_.reset();
    }
}

std::shared_ptr<const Raster> Stroke::stroked() const {
    const auto drawn = [&](const auto& work) {
        return with_shape(working_,
                          {.work = work, .rays = style_.rays, .form = style_.form, .from = begin_, .to = at_},
                          style_.brush, style_.symmetry);
    };
    const PaintToolInfo& tool = info(style_.tool);
    if (const auto* distance = std::get_if<ShapeDistance>(&tool.work)) return drawn(*distance);
    if (const auto* gradient = std::get_if<GradientTool>(&tool.work)) return drawn(*gradient);
    return std::make_shared<const Raster>(working_);
}

// How much of the stroke a texel takes.
double Stroke::share(std::size_t texel) const {
    const double selected = style_.selected ? static_cast<double>((*style_.selected)[texel]) : 1;
    return style_.brush.opacity * selected;
}

std::shared_ptr<const Raster> Stroke::raster() {
    if (published_) return published_;
    published_ = stroked();
    if (before_.empty()) return published_;
    auto mixed = std::make_shared<Raster>(*published_);
    for (std::size_t i = 0; i < before_.size(); ++i)
        mixed->values[i] = static_cast<float>(
            std::lerp(static_cast<double>(before_[i]), static_cast<double>(mixed->values[i]), share(i)));
    published_ = std::move(mixed);
    return published_;
}

std::shared_ptr<const Raster> painted_over(const Raster& before, const TexelShares& selected,
                                           const Brush& brush) {
    auto raster = std::make_shared<Raster>(before);
    for (std::size_t i = 0; i < selected.size(); ++i)
        if (selected[i] > 0)
            raster->values[i] = static_cast<float>(painted(brush, static_cast<double>(before.values[i]),
                                                           brush.opacity * static_cast<double>(selected[i])));
    return raster;
}

}  // namespace nacre
