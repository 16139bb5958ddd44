#include "core/paint/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/coverage.h"

namespace nacre {
namespace {

constexpr double shortest = 1e-9;  // radians; a shape that has not been drawn out yet

// How much of the full effect a shape has at h.
class AmountOf {
  public:
    AmountOf(const Shape& shape, const Brush& brush)
        : shape_(shape),
          brush_(brush),
          size_{.length = angle_between(shape.from, shape.to),
                .radius = brush.radius * (std::numbers::pi / 180),
                .rays = shape.rays,
                .form = shape.form} {
        const dvec3 toward = shape.to - shape.from * glm::dot(shape.from, shape.to);
        const dvec3 away = std::abs(shape.from.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
        along_ =
            glm::normalize(size_.length > shortest ? toward : away - shape.from * glm::dot(shape.from, away));
        across_ = glm::cross(shape.from, along_);
    }

    double operator()(dvec3 h) const {
        const double turn = std::atan2(glm::dot(h, across_), glm::dot(h, along_));
        const double middle = angle_between(h, shape_.from);
        if (const auto* gradient = std::get_if<GradientTool>(&shape_.work))
            return gradient->amount(size_, middle, turn);
        const auto distance = std::get<ShapeDistance>(shape_.work);
        return brush_.flow * brush_falloff(brush_, distance(size_, middle, turn));
    }

    // From `from` to the farthest point of the shape.
    double reach() const {
        return std::holds_alternative<GradientTool>(shape_.work) ? std::numbers::pi
                                                                 : size_.length + size_.radius;
    }

  private:
    Shape shape_;
    Brush brush_;
    ShapeSize size_;
    dvec3 along_, across_;
};

}  // namespace

RayPlace ray_place(double middle, double turn) {
    return {.along = std::atan2(std::sin(middle) * std::cos(turn), std::cos(middle)),
            .off = std::asin(std::clamp(std::sin(middle) * std::sin(turn), -1.0, 1.0))};
}

std::shared_ptr<const Raster> with_shape(const Raster& before, const Shape& shape, const Brush& brush,
                                         const BrushSymmetry& symmetry) {
    auto raster = std::make_shared<Raster>(before);
    const AmountOf amount(shape, brush);
    Coverage coverage(raster->width);
    visit_images(raster->width, symmetry, shape.from, amount.reach(),
                 [&](const SeenTexel& texel) { coverage.add(texel.index, amount(texel.original)); });
    coverage.paint(raster->values, brush);
    return raster;
}

}  // namespace nacre
