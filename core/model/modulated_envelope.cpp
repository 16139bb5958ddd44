#include "core/model/modulated_envelope.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace nacre {
namespace {

// The brightest texel of squares of a picture: one texel a side, then two, four, ...
class BrightestTexels {
  public:
    explicit BrightestTexels(const Raster& picture) {
        levels_.push_back({picture.width, picture.values});
        while (levels_.back().side > 1) {
            const Level& finer = levels_.back();
            Level level{(finer.side + 1) / 2, {}};
            for (int row = 0; row < level.side; ++row)
                for (int column = 0; column < level.side; ++column)
                    level.values.push_back(
                        brightest(finer, 2 * row, 2 * row + 1, 2 * column, 2 * column + 1));
            levels_.push_back(std::move(level));
        }
    }

    // Of all texels that are read between two corners of a rectangle on the disk.
    double between(dvec2 low, dvec2 high) const {
        const int side = levels_.front().side;
        const auto texel = [&](double along) {
            return std::clamp(0.5 * (1 + along) * side - 0.5, 0.0, side - 1.0);
        };
        const int left = static_cast<int>(texel(low.x)), right = static_cast<int>(std::ceil(texel(high.x)));
        const int top = static_cast<int>(texel(-high.y)), bottom = static_cast<int>(std::ceil(texel(-low.y)));
        int level = 0;
        while (std::max(right - left, bottom - top) >> level > 8) ++level;
        return static_cast<double>(brightest(levels_[static_cast<std::size_t>(level)], top >> level,
                                             bottom >> level, left >> level, right >> level));
    }

  private:
    struct Level {
        int side;
        std::vector<float> values;
    };

    static float brightest(const Level& level, int top, int bottom, int left, int right) {
        float most = 0;
        for (int row = top; row <= std::min(bottom, level.side - 1); ++row)
            for (int column = left; column <= std::min(right, level.side - 1); ++column)
                most = std::max(
                    most, level.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(level.side) +
                                       static_cast<std::size_t>(column)]);
        return most;
    }

    std::vector<Level> levels_;
};

class ModulatedEnvelope final : public LobeEnvelope {
  public:
    ModulatedEnvelope(std::unique_ptr<const LobeEnvelope> lobe, const ModulationFactor& factor)
        : lobe_(std::move(lobe)), factor_(factor), brightest_(factor.picture()) {}

    std::vector<FacetPatch> whole() const override { return modulated(lobe_->whole()); }
    std::vector<Parts> splits(const FacetPatch& patch) const override {
        std::vector<Parts> ways = lobe_->splits(patch);
        for (Parts& parts : ways) parts = modulated(std::move(parts));
        return ways;
    }
    double scale() const override { return lobe_->scale(); }

    Draw draw(const FacetPatch& patch, Random& random) const override {
        const Draw drawn = lobe_->draw(patch, random);
        return {drawn.h, drawn.part > 0 ? drawn.part * factor_(drawn.h) / patch.factor : 0};
    }

  private:
    std::vector<FacetPatch> modulated(std::vector<FacetPatch> patches) const {
        for (FacetPatch& patch : patches) {
            patch.factor = most_over(patch);
            patch.mass *= patch.factor;
        }
        std::erase_if(patches, [](const FacetPatch& patch) { return !(patch.mass > 0); });
        return patches;
    }

    double most_over(const FacetPatch& patch) const {
        const bool faces_up = patch.centre.z > -patch.radius;
        return factor_.of(faces_up ? brightest_.between(patch.low, patch.high) : 0);
    }

    std::unique_ptr<const LobeEnvelope> lobe_;
    const ModulationFactor& factor_;
    BrightestTexels brightest_;
};

}  // namespace

std::unique_ptr<const LobeEnvelope> make_modulated_envelope(std::unique_ptr<const LobeEnvelope> lobe,
                                                            const ModulationFactor& factor) {
    if (!lobe) return nullptr;
    return std::make_unique<const ModulatedEnvelope>(std::move(lobe), factor);
}

}  // namespace nacre
