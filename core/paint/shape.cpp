#include "core/paint/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/coverage.h"
#include "core/paint/painted_layer.h"

namespace nacre {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double shortest = 1e-9;  // radians; a shape that has not been drawn out yet

// How far h lies from a shape, in brush radii. All angles in radians.
class ShapeDistance {
  public:
    ShapeDistance(const Shape& shape, double radius)
        : shape_(shape), radius_(radius), length_(angle_between(shape.from, shape.to)) {
        const dvec3 toward = shape.to - shape.from * glm::dot(shape.from, shape.to);
        const dvec3 away = std::abs(shape.from.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
        along_ = glm::normalize(length_ > shortest ? toward : away - shape.from * glm::dot(shape.from, away));
        across_ = glm::cross(shape.from, along_);
    }

    double operator()(dvec3 h) const {
        const double middle = angle_between(h, shape_.from);
        if (shape_.kind == ShapeKind::ring) return std::abs(middle - length_) / radius_;
        double turn = std::atan2(glm::dot(h, across_), glm::dot(h, along_));
        if (shape_.kind == ShapeKind::star) turn = std::remainder(turn, 2 * std::numbers::pi / shape_.rays);
        return segment(middle, turn);
    }

    // From `from` to the farthest point of the shape.
    double reach() const { return length_ + radius_; }

  private:
    // Of a point at polar angle `middle` about `from` and azimuth `turn` off the segment. A star's ray
    // narrows.
    double segment(double middle, double turn) const {
        const double off = std::asin(std::clamp(std::sin(middle) * std::sin(turn), -1.0, 1.0));
        const double along = std::atan2(std::sin(middle) * std::cos(turn), std::cos(middle));
        if (along <= 0) return middle / radius_;
        if (shape_.kind == ShapeKind::star) {
            const double breadth = radius_ * (1 - along / std::max(length_, shortest));
            return breadth > 0 ? std::abs(off) / breadth : HUGE_VAL;
        }
        if (along <= length_) return std::abs(off) / radius_;
        const double past = std::acos(std::clamp(std::cos(off) * std::cos(along - length_), -1.0, 1.0));
        return past / radius_;
    }

    Shape shape_;
    double radius_, length_;
    dvec3 along_, across_;
};

}  // namespace

std::shared_ptr<const Raster> with_shape(const Raster& before, const Shape& shape, const Brush& brush,
                                         const BrushSymmetry& symmetry) {
    auto raster = std::make_shared<Raster>(before);
    Shape inside = shape;
    inside.from = above_horizon(shape.from);
    inside.to = above_horizon(shape.to);
    const ShapeDistance distance(inside, brush.radius * radians);
    Coverage coverage(raster->width);
    visit_images(raster->width, symmetry, inside.from, distance.reach(), [&](const SeenTexel& texel) {
        coverage.add(texel.index, brush.flow * brush_falloff(brush, distance(texel.original)));
    });
    coverage.pull(raster->values, [](std::size_t) { return 1.0; });
    return raster;
}

}  // namespace nacre
