#pragma once

#include <cmath>
#include <memory>
#include <tuple>

#include "core/model/lobe_model.h"
#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

// p ~ 1 - s + s cos(theta) over the upper hemisphere: from uniform to a cosine.
struct DomeLobe {
    double strength = 0.5;
    bool operator==(const DomeLobe&) const = default;

    static constexpr const char* name = "dome";
    static constexpr const char* label = "Dome";
    static constexpr const char* explanation = "A matt surface that leans a little to the normal.";
    static constexpr auto parameters() {
        return std::tuple{
            NumberParameter<DomeLobe>{.member = &DomeLobe::strength,
                                      .text = {"strength", "Strength", "From uniform to a cosine."},
                                      .bounds = {0, 1},
                                      .slider = {.ends = {0, 1}}}};
    }

    static constexpr WidthMembers<DomeLobe> width_members{};
    static DomeLobe of_widths(glm::dvec2) { return {}; }
    double period() const { return 0; }
    bool reaches_below() const { return false; }
    const char* table_kind() const { return name; }
    const char* formula() const { return "1 - i + i z"; }
    ShaderLobe shader() const { return {.inverse_width = {strength, 0}}; }
    std::shared_ptr<const LobeModel> model() const;
};

class DomeModel final : public LobeModel {
  public:
    explicit DomeModel(double strength) : s_(strength) {}

    double density(dvec3 h) const override { return h.z > 0 ? 1 - s_ + s_ * h.z : 0; }
    double mass() const override { return 2 * pi * (1 - s_) + pi * s_; }
    std::vector<LobeParameterization> spans() const override { return {{dvec2{1}, 1, {}}}; }

    // Of 1: (pi/2)(1 + cos gamma). Of the cosine: (2/3)(sin gamma + (pi - gamma) cos gamma), gamma from n to
    // k.
    Area area(dvec3 k) const override {
        const double length = glm::length(k);
        if (length == 0) return {};
        const dvec3 n{0, 0, 1}, e = k / length;
        const double gamma = std::atan2(std::hypot(e.x, e.y), e.z);
        const dvec3 flat = 0.5 * pi * (e + n);
        const dvec3 cosine = 2.0 / 3 * (std::sin(gamma) * e + (pi - gamma) * n);
        const dvec3 gradient = (1 - s_) * flat + s_ * cosine;
        return {glm::dot(k, gradient), gradient};
    }

    // By rejection: facets as k sees them without p, then by p.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const dvec3 e = glm::normalize(k);
        while (true) {
            const double z = 1 - 2 * uniform_random(random), phi = 2 * pi * uniform_random(random);
            const double r = std::sqrt(1 - z * z);
            const dvec3 h = glm::normalize(dvec3{r * std::cos(phi), r * std::sin(phi), z} + e);
            if (uniform_random(random) < density(h)) return h;
        }
    }

  private:
    static constexpr double pi = 3.14159265358979323846;
    double s_;
};

inline std::shared_ptr<const LobeModel> DomeLobe::model() const {
    return std::make_shared<DomeModel>(strength);
}

}  // namespace nacre
