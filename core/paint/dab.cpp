#include "core/paint/dab.h"

#include <cmath>
#include <numbers>

#include "core/paint/coverage.h"

namespace nacre {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double erased = 1e-4;  // under the eraser this is none

// 1 4 6 4 1 over 16, both ways, `step` texels apart, of the texels that hold facets. Its sums pair what a
// mirror swaps.
class Smoother {
  public:
    Smoother(std::vector<float> before, int side, double radius) : values_(std::move(before)), side_(side) {
        step_ = std::max(1, static_cast<int>(std::lround(radius / 10 * side / 2)));
    }

    double operator()(std::size_t index) const {
        const int row = static_cast<int>(index) / side_, column = static_cast<int>(index) % side_;
        const dvec2 sum = 6.0 * across(row, column) +
                          4.0 * (across(row - step_, column) + across(row + step_, column)) +
                          (across(row - 2 * step_, column) + across(row + 2 * step_, column));
        return sum.y > 0 ? sum.x / sum.y : static_cast<double>(values_[index]);
    }

  private:
    // Sum of values and of weights.
    dvec2 across(int row, int column) const {
        return 6.0 * texel(row, column) + 4.0 * (texel(row, column - step_) + texel(row, column + step_)) +
               (texel(row, column - 2 * step_) + texel(row, column + 2 * step_));
    }
    dvec2 texel(int row, int column) const {
        if (row < 0 || column < 0 || row >= side_ || column >= side_) return {0, 0};
        if (!holds_facets(texel_point(side_, row, column))) return {0, 0};
        return {values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                        static_cast<std::size_t>(column)],
                1};
    }

    std::vector<float> values_;
    int side_;
    int step_;
};

// What lay where the brush came from.
class Smear {
  public:
    Smear(const Raster& raster, const Dab& dab)
        : before_(extended_past_rim(raster).values),
          side_(raster.width),
          ring_(dab.symmetry.kind == SymmetryKind::ring) {
        dvec3 from = dab.from;
        if (ring_) {  // only the way from or to the pole counts
            const double sine = std::hypot(dab.at.x, dab.at.y), r = std::hypot(from.x, from.y);
            from = sine > 0 ? dvec3(dab.at.x / sine * r, dab.at.y / sine * r, from.z) : dvec3(r, 0, from.z);
        }
        back_ = glm::transpose(shortest_rotation(from, dab.at));
        images_ = symmetry_images(dab.symmetry);
    }

    double operator()(const SeenTexel& texel) const {
        dvec3 source = back_ * texel.original;
        if (ring_) {
            const double r = std::hypot(texel.h.x, texel.h.y), s = std::hypot(source.x, source.y);
            source = r > 0 ? dvec3(texel.h.x / r * s, texel.h.y / r * s, source.z) : dvec3(s, 0, source.z);
        } else {
            source = images_[texel.image] * source;
        }
        return raster_value(before_, side_, disk_point(source));
    }

  private:
    std::vector<float> before_;
    int side_;
    bool ring_;
    glm::dmat3 back_;
    std::vector<glm::dmat3> images_;
};

// The tip's value at h: the picture lies on the sphere about the dab, angles from its middle as lengths, its
// upper edge where +y is when the pole is carried to the dab.
class Tip {
  public:
    explicit Tip(const Dab& dab)
        : raster_(*dab.tip),
          radius_(dab.brush.radius * radians),
          to_pole_(glm::transpose(shortest_rotation({0, 0, 1}, dab.at))) {}

    double operator()(dvec3 h) const {
        const dvec3 l = to_pole_ * h;
        const double sine = std::hypot(l.x, l.y);
        const double angle = std::atan2(sine, l.z) / radius_;
        const dvec2 at = sine > 0 ? dvec2(l.x, l.y) * (angle / sine) : dvec2(0);
        if (std::max(std::abs(at.x), std::abs(at.y)) >= 1) return 0;
        return std::clamp(raster_value(raster_.values, raster_.width, at), 0.0, 1.0);
    }

  private:
    const Raster& raster_;
    double radius_;
    glm::dmat3 to_pole_;
};

// Calls visit(texel, amount) for what the brush covers.
template <class Visit>
void visit_covered(const Raster& raster, const Dab& dab, const Visit& visit) {
    const double radius = dab.brush.radius * radians;
    const double chord = 2 * std::sin(0.5 * std::min(radius, std::numbers::pi));
    visit_images(raster.width, dab.symmetry, dab.at, radius, [&](const SeenTexel& texel) {
        const dvec3 off = texel.original - dab.at;
        if (glm::dot(off, off) >= chord * chord) return;
        visit(texel,
              dab.brush.flow * brush_falloff(dab.brush, angle_between(texel.original, dab.at) / radius));
    });
}

void cover(const Raster& raster, const Dab& dab, Coverage& coverage) {
    visit_covered(raster, dab,
                  [&](const SeenTexel& texel, double amount) { coverage.add(texel.index, amount); });
}

void cover_by_tip(const Raster& raster, const Dab& dab, Coverage& coverage) {
    const Tip tip(dab);
    const double reach = dab.brush.radius * radians * std::numbers::sqrt2;
    visit_images(raster.width, dab.symmetry, dab.at, reach, [&](const SeenTexel& texel) {
        coverage.add(texel.index, dab.brush.flow * tip(texel.original));
    });
}

void erase(Raster& raster, const Dab& dab, Coverage& coverage) {
    cover(raster, dab, coverage);
    const std::vector<std::size_t> touched = coverage.touched();
    coverage.pull(raster.values, [](std::size_t) { return 0.0; });
    for (const std::size_t index : touched)
        if (static_cast<double>(raster.values[index]) < erased) raster.values[index] = 0;
}

void smear(Raster& raster, const Dab& dab, Coverage& coverage) {
    const Smear source(raster, dab);
    visit_covered(raster, dab, [&](const SeenTexel& texel, double amount) {
        coverage.add(texel.index, amount, source(texel));
    });
    coverage.pull(raster.values, [&](std::size_t index) { return coverage.target(index); });
}

}  // namespace

void apply_dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    const auto full = [](std::size_t) { return 1.0; };
    switch (dab.tool) {
        case PaintTool::paint:
            cover(raster, dab, scratch);
            scratch.pull(raster.values, full);
            break;
        case PaintTool::erase:
            erase(raster, dab, scratch);
            break;
        case PaintTool::smooth: {
            const Smoother smoother(raster.values, raster.width, dab.brush.radius * radians);
            cover(raster, dab, scratch);
            scratch.pull(raster.values, smoother);
            break;
        }
        case PaintTool::smear:
            smear(raster, dab, scratch);
            break;
        case PaintTool::stamp:
            if (dab.tip) cover_by_tip(raster, dab, scratch);
            scratch.pull(raster.values, full);
            break;
    }
}

}  // namespace nacre
