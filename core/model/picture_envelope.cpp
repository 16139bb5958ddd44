#include "core/model/picture_envelope.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "core/model/disk_texels.h"
#include "core/model/pyramid_tile.h"

namespace nacre {
namespace {

constexpr std::size_t block = 16;  // texels in Morton order, of which one sum is kept

// Bilinear between texels' middles and flat beyond the outermost, the picture is the sum of its values times
// tents, which all hold the same area of the equal-area disk. A texel is drawn by its value and a place under
// its tent; only the rim cuts some of it off.
class PictureEnvelope final : public LobeEnvelope {
  public:
    explicit PictureEnvelope(const Raster& picture) : side_(picture.width) {
        const std::size_t full = std::max<std::size_t>(std::bit_ceil(static_cast<std::size_t>(side_)), 4);
        values_.assign(full * full, 0.0F);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const int row = morton_row(i), column = morton_column(i);
            if (row < side_ && column < side_)
                values_[i] = picture.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                                            static_cast<std::size_t>(column)];
        }
        rising_.push_back(0);
        for (std::size_t i = 0; i < values_.size(); i += block) {
            double sum = 0;
            for (std::size_t j = i; j < i + block; ++j) sum += static_cast<double>(values_[j]);
            rising_.push_back(rising_.back() + sum);
        }
    }

    std::vector<FacetPatch> whole() const override {
        std::vector<FacetPatch> patches;
        add({0, values_.size()}, patches);
        return patches;
    }

    std::vector<Parts> splits(const FacetPatch& patch) const override {
        const std::size_t quarter = (patch.texels.end - patch.texels.begin) / 4;
        if (quarter == 0) return {};
        Parts parts;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t begin = patch.texels.begin + i * quarter;
            add({begin, begin + quarter}, parts);
        }
        return {parts};
    }

    double scale() const override { return 0.1; }

    Draw draw(const FacetPatch& patch, Random& random) const override {
        const std::size_t texel = draw_texel(patch.texels, uniform_random(random));
        const double x = place(morton_column(texel), uniform_random(random));
        const double y = -place(morton_row(texel), uniform_random(random));
        const bool inside = x * x + y * y < 1;
        return {inside ? disk_direction({x, y}) : dvec3{0, 0, 1}, inside ? 1.0 : 0.0};
    }

  private:
    double sum_of(const TexelRange& texels) const {
        if (texels.end - texels.begin >= block)
            return rising_[texels.end / block] - rising_[texels.begin / block];
        double sum = 0;
        for (std::size_t i = texels.begin; i < texels.end; ++i) sum += static_cast<double>(values_[i]);
        return sum;
    }

    // Without branches, which no processor could guess.
    std::size_t draw_texel(const TexelRange& texels, double u) const {
        double left = u * sum_of(texels);
        std::size_t size = texels.end - texels.begin, first = texels.begin;
        if (size > block) {
            std::size_t at = first / block;
            const double target = rising_[at] + left;
            for (size /= 2 * block; size > 0; size /= 2) at += target >= rising_[at + size] ? size : 0;
            left = target - rising_[at];
            first = at * block;
            size = block;
        }
        if (size == block) {
            std::array<double, 4> fours;
            for (std::size_t i = 0; i < 4; ++i) fours[i] = sum_of({first + 4 * i, first + 4 * i + 4});
            first += 4 * one_of(fours.data(), left);
        }
        return size == 1 ? first : first + one_of(&values_[first], left);
    }

    // The one of four numbers on which `left` falls, and what is left of it there.
    template <class Number>
    static std::size_t one_of(const Number* four, double& left) {
        std::array<double, 4> before{};
        for (std::size_t i = 1; i < 4; ++i) before[i] = before[i - 1] + static_cast<double>(four[i - 1]);
        const auto reaches = [&](std::size_t i) { return static_cast<std::size_t>(left >= before[i]); };
        const std::size_t chosen = reaches(1) + reaches(2) + reaches(3);
        left -= before[chosen];
        return chosen;
    }

    // Under a tent along one axis, from -1 to 1 across the picture. The outer half is flat where the tent is
    // the outermost.
    double place(int index, double u) const {
        double off = std::copysign(1 - std::sqrt(2 * std::min(u, 1 - u)), u - 0.5);
        if ((index == 0 && off < 0) || (index == side_ - 1 && off > 0)) off = u - 0.5;
        return (2 * (index + off) + 1 - side_) / side_;
    }

    void add(const TexelRange& texels, std::vector<FacetPatch>& patches) const {
        FacetPatch patch;
        patch.texels = texels;
        patch.mass = sum_of(texels) * texel_solid_angle(side_);
        if (patch.mass > 0 && enclose(patch)) patches.push_back(patch);
    }

    // The tents' square on the disk. From the disk to the sphere no length grows more than by 2/sqrt(2 -
    // r^2), along the radius; what lies on the disk is no farther from a centre that is moved there. Whether
    // any of it does.
    bool enclose(FacetPatch& patch) const {
        const double texel = 2.0 / side_;
        const int size = 1 << (std::bit_width(patch.texels.end - patch.texels.begin) / 2);
        const auto span = [&](int first) {
            return dvec2(std::max((first - 0.5) * texel - 1, -1.0),
                         std::min((first + size + 0.5) * texel - 1, 1.0));
        };
        const dvec2 x = span(morton_column(patch.texels.begin)), y = span(morton_row(patch.texels.begin));
        const dvec2 low{x.x, y.x}, high{x.y, y.y};
        const dvec2 nearest = glm::clamp(dvec2{0}, low, high);
        if (glm::dot(nearest, nearest) >= 1) return false;
        dvec2 middle = 0.5 * (low + high);
        const double reach = 0.5 * glm::length(high - low);
        middle /= std::max(glm::length(middle), 1.0);
        const double farthest = std::min(glm::length(middle) + reach, 1.0);
        patch.low = {low.x, -high.y};
        patch.high = {high.x, -low.y};
        patch.centre = disk_direction({middle.x, -middle.y});
        patch.radius = 2 / std::sqrt(2 - farthest * farthest) * reach;
        return true;
    }

    int side_;
    std::vector<float> values_;   // of the texels in Morton order
    std::vector<double> rising_;  // sums of the blocks before each
};

}  // namespace

std::unique_ptr<const LobeEnvelope> make_picture_envelope(const Raster& picture) {
    return std::make_unique<const PictureEnvelope>(picture);
}

}  // namespace nacre
