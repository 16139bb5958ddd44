// What a dab or a shape covers, copies included.
#pragma once

#include <vector>

#include "core/paint/brush.h"
#include "core/paint/raster_texels.h"

namespace nacre {

// A texel as one copy of the dab sees it: `h` moved to where the original dab lies.
struct SeenTexel {
    std::size_t index;
    dvec3 h;         // of the texel
    dvec3 original;  // as the original dab sees it
    std::size_t image;
};

// Calls visit(SeenTexel) for each texel within `reach` (radians) of `middle` or of one of its copies, once
// for each copy that is near. A full ring turns every texel to the middle's azimuth.
template <class Visit>
void visit_images(int side, const BrushSymmetry& symmetry, dvec3 middle, double reach, const Visit& visit) {
    if (symmetry.kind == SymmetryKind::ring) {
        const double sine = std::hypot(middle.x, middle.y);
        const dvec2 along = sine > 0 ? dvec2(middle.x, middle.y) / sine : dvec2(1, 0);
        const double angle = std::atan2(sine, middle.z);
        visit_texels(side, {0, 0, 1}, angle + reach, [&](std::size_t index, dvec3 h) {
            const double r = std::hypot(h.x, h.y);
            visit(SeenTexel{index, h, dvec3(along * r, h.z), 0});
        });
        return;
    }
    const std::vector<glm::dmat3> images = symmetry_images(symmetry);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const glm::dmat3 back = glm::transpose(images[i]);
        visit_texels(side, images[i] * middle, reach, [&](std::size_t index, dvec3 h) {
            visit(SeenTexel{index, h, back * h, i});
        });
    }
}

// The strongest coverage of each texel by any copy, and which texels there are. One serves many dabs: what it
// costs is what is touched.
class Coverage {
  public:
    explicit Coverage(int side) : amount_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}

    void add(std::size_t index, double amount) {
        if (!(amount > 0)) return;
        if (amount_[index] == 0) touched_.push_back(index);
        amount_[index] = std::max(amount_[index], amount);
    }

    // The same with what the copy would have there: of several, their mean by amount.
    void add(std::size_t index, double amount, double target) {
        if (!(amount > 0)) return;
        sum_.resize(amount_.size());
        weight_.resize(amount_.size());
        if (amount_[index] == 0) sum_[index] = weight_[index] = 0;
        sum_[index] += amount * target;
        weight_[index] += amount;
        add(index, amount);
    }

    const std::vector<std::size_t>& touched() const { return touched_; }
    double amount(std::size_t index) const { return amount_[index]; }
    double target(std::size_t index) const { return sum_[index] / weight_[index]; }

    void clear() {
        for (const std::size_t index : touched_) amount_[index] = 0;
        touched_.clear();
    }

    // Paints each touched value by its amount, and forgets all.
    void paint(std::vector<float>& values, const Brush& brush) {
        for (const std::size_t index : touched_)
            values[index] =
                static_cast<float>(painted(brush, static_cast<double>(values[index]), amount_[index]));
        clear();
    }

    // Moves each touched value toward its target by its amount, and forgets all.
    template <class Target>
    void pull(std::vector<float>& values, const Target& target) {
        for (const std::size_t index : touched_) {
            const double value = static_cast<double>(values[index]);
            values[index] = static_cast<float>(value + amount_[index] * (target(index) - value));
        }
        clear();
    }

  private:
    std::vector<double> amount_, sum_, weight_;
    std::vector<std::size_t> touched_;
};

}  // namespace nacre
