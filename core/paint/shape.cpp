#include "core/paint/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/coverage.h"

namespace nacre {
namespace {

constexpr double shortest = 1e-9;  // radians; a shape that has not been drawn out yet

// How far h lies from a shape, in brush radii.
class DistanceFrom {
  public:
    DistanceFrom(const Shape& shape, double radius)
        : shape_(shape), size_{angle_between(shape.from, shape.to), radius, shape.rays} {
        const dvec3 toward = shape.to - shape.from * glm::dot(shape.from, shape.to);
        const dvec3 away = std::abs(shape.from.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
        along_ =
            glm::normalize(size_.length > shortest ? toward : away - shape.from * glm::dot(shape.from, away));
        across_ = glm::cross(shape.from, along_);
    }

    double operator()(dvec3 h) const {
        const double turn = std::atan2(glm::dot(h, across_), glm::dot(h, along_));
        return shape_.distance(size_, angle_between(h, shape_.from), turn);
    }

    // From `from` to the farthest point of the shape.
    double reach() const { return size_.length + size_.radius; }

  private:
    Shape shape_;
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
    const DistanceFrom distance(shape, brush.radius * (std::numbers::pi / 180));
    Coverage coverage(raster->width);
    visit_images(raster->width, symmetry, shape.from, distance.reach(), [&](const SeenTexel& texel) {
        coverage.add(texel.index, brush.flow * brush_falloff(brush, distance(texel.original)));
    });
    coverage.paint(raster->values, brush);
    return raster;
}

}  // namespace nacre
