#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "core/image/raster.h"
#include "core/model/kinds/kind.h"
#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;
enum class Fineness;
struct Modulation;

struct PaintedLobe {
    Picture image;
    bool operator==(const PaintedLobe&) const = default;

    static constexpr const char* name = "painted";
    static constexpr const char* label = "Painted";
    static constexpr const char* explanation =
        "p as a picture of the hemisphere seen from above.\n"
        "p ~ the picture's brightness at (x, y)/\u221a(1 + z) of the facet normal (x, y, z)";
    static constexpr auto parameters() {
        return std::tuple{PictureParameter<PaintedLobe>{.member = &PaintedLobe::image,
                                                        .text = {"image", "Picture", explanation}}};
    }

    static constexpr WidthMembers<PaintedLobe> width_members{};

    // A round Gaussian dab in the middle of the equal-area disk, so that a new painted layer is a valid
    // design.
    static PaintedLobe of_widths(glm::dvec2 widths) {
        constexpr int side = 256;
        const double width = std::clamp(std::min(finite_width(widths.x), finite_width(widths.y)), 1e-2, 2.0);
        auto raster = std::make_shared<Raster>();
        raster->width = raster->height = side;
        raster->values.reserve(std::size_t{side} * side);
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double x = 2 * (column + 0.5) / side - 1;
                const double y = 2 * (row + 0.5) / side - 1;
                const double squared = x * x + y * y;  // of the disk's radius: 1 - cos theta
                const double cosine = 1 - squared;
                const double tangent2 = cosine > 0 ? 1 / (cosine * cosine) - 1 : HUGE_VAL;
                raster->values.push_back(static_cast<float>(std::exp(-tangent2 / (width * width))));
            }
        return {.image = {.file = {}, .raster = std::move(raster)}};
    }

    std::optional<KindFault> fault() const {
        if (!is_black(image)) return {};
        return KindFault{"image", "the picture needs a pixel above 0", "all black: no facets"};
    }

    double period() const { return 360; }
    bool reaches_below() const { return false; }
    const char* table_kind() const { return name; }
    const char* formula() const { return "picture(x, y, z)"; }
    ShaderLobe shader() const;

    // Its own picture and a modulation's are one picture to it. A product that is 0 everywhere has mass 0.
    std::shared_ptr<const LobeModel> modulated_model(const std::optional<Modulation>& modulation,
                                                     Fineness fineness) const;
};

}  // namespace nacre
