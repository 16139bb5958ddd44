#include "core/model/picture_lobe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/model/moment_pyramid.h"
#include "core/model/shading.h"

namespace nacre {
namespace {

using std::numbers::pi;

// The direction at a point of the equal-area disk, which has radius 1 at the horizon.
dvec3 disk_direction(dvec2 at) {
    const double r2 = glm::dot(at, at);
    const double scale = std::sqrt(2 - r2);
    return {at.x * scale, at.y * scale, 1 - r2};
}

double picture_at(const Raster& raster, dvec3 h) {
    Shading<double> shading;
    shading.data = raster.values.data();
    return shading.picture_value(h, 0, raster.width);
}

// 1 - strength + strength * picture.
double modulation_factor(const Modulation& modulation, dvec3 h) {
    return 1 - modulation.strength + modulation.strength * picture_at(*modulation.image.raster, h);
}

// p is bilinear between texel centres; the set of facets that stands for it has at least 256 of them a side.
class Painted final : public LobeModel {
  public:
    Painted(const PaintedLobe& lobe, const std::optional<Modulation>& modulation)
        : raster_(lobe.image.raster), modulation_(modulation) {
        int finer = 1;
        while (raster_->width * finer < 256) finer *= 2;
        cells_ = raster_->width * finer;
        side_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells_)));
        std::vector<Facet> facets(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        const double solid_angle = 2 * (2.0 / cells_) * (2.0 / cells_);
        for (int row = 0; row < cells_; ++row) {
            for (int column = 0; column < cells_; ++column) {
                const dvec2 at = disk_point(row + 0.5, column + 0.5);
                if (glm::dot(at, at) >= 1) continue;
                const dvec3 h = disk_direction(at);
                facets[static_cast<std::size_t>(row * side_ + column)] = {h, density(h) * solid_angle};
            }
        }
        pyramid_ = std::make_unique<MomentPyramid>(side_, facets);
    }

    double density(dvec3 h) const override {
        const double p = picture_at(*raster_, h);
        return modulation_ ? p * modulation_factor(*modulation_, h) : p;
    }
    double mass() const override { return pyramid_->mass(); }
    Area area(dvec3 k) const override { return pyramid_->area(k); }
    dvec3 mean() const override { return pyramid_->mean(); }
    std::vector<LobeSpan> spans() const override { return {}; }
    std::vector<Facet> facets(std::size_t count) const override { return pyramid_->facets(count); }

    // A cell by descent, then a place in it by rejection; p is bilinear on the quarters of a cell, so that
    // its corners, edges' middles and centre bound it.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const std::size_t index = pyramid_->sample_visible(k, random);
        const double row = static_cast<double>(index / static_cast<std::size_t>(side_));
        const double column = static_cast<double>(index % static_cast<std::size_t>(side_));
        double peak = 0;
        for (int i = 0; i < 9; ++i) {
            const dvec2 at = disk_point(row + 0.5 * (i / 3), column + 0.5 * (i % 3));
            peak = std::max(peak, density(disk_direction(at * std::min(1.0, (1 - 1e-12) / glm::length(at)))));
        }
        const double reach = 4.0 / cells_;
        const double seen = glm::dot(k, disk_direction(disk_point(row + 0.5, column + 0.5))) + reach;
        for (;;) {
            const dvec2 at = disk_point(row + uniform_random(random), column + uniform_random(random));
            if (glm::dot(at, at) >= 1) continue;
            const dvec3 h = disk_direction(at);
            if (uniform_random(random) * peak * seen < density(h) * glm::dot(k, h)) return h;
        }
    }

  private:
    dvec2 disk_point(double row, double column) const {
        return {2 * column / cells_ - 1, 1 - 2 * row / cells_};
    }

    std::shared_ptr<const Raster> raster_;
    std::optional<Modulation> modulation_;
    int cells_ = 0;
    int side_ = 0;
    std::unique_ptr<MomentPyramid> pyramid_;
};

// The base lobe's own coordinates carry the facets, so that a narrow lobe is resolved whatever the picture's
// size.
class Modulated final : public LobeModel {
  public:
    Modulated(std::shared_ptr<const LobeModel> base, const Modulation& modulation)
        : base_(std::move(base)), modulation_(modulation) {
        const std::vector<float>& values = modulation.image.raster->values;
        const double brightest = *std::max_element(values.begin(), values.end());
        peak_ = 1 - modulation.strength + modulation.strength * std::max(brightest, 0.0);
        for (const LobeSpan& span : base_->spans()) pyramids_.push_back(make_pyramid(span));
    }

    double density(dvec3 h) const override { return base_->density(h) * modulation_factor(modulation_, h); }

    double mass() const override {
        double sum = 0;
        for (const MomentPyramid& pyramid : pyramids_) sum += pyramid.mass();
        return sum;
    }

    Area area(dvec3 k) const override {
        Area sum;
        for (const MomentPyramid& pyramid : pyramids_) {
            const Area part = pyramid.area(k);
            sum.g += part.g;
            sum.gradient += part.gradient;
        }
        return sum;
    }

    dvec3 mean() const override {
        dvec3 sum{0};
        for (const MomentPyramid& pyramid : pyramids_) sum += pyramid.mean();
        return sum;
    }

    std::vector<LobeSpan> spans() const override { return {}; }

    std::vector<Facet> facets(std::size_t count) const override {
        std::vector<Facet> all;
        for (const MomentPyramid& pyramid : pyramids_) {
            const std::vector<Facet> part = pyramid.facets(count);
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    }

    dvec3 sample_visible(dvec3 k, Random& random) const override {
        for (;;) {
            const dvec3 h = base_->sample_visible(k, random);
            if (uniform_random(random) * peak_ < modulation_factor(modulation_, h)) return h;
        }
    }

  private:
    static constexpr int side = 256;

    MomentPyramid make_pyramid(const LobeSpan& span) const {
        std::vector<Facet> facets(static_cast<std::size_t>(side) * side);
        const double patch = 2 * pi / side / side * span.stretch.x * span.stretch.y;
        for (int i = 0; i < side; ++i) {
            const double t = (i + 0.5) / side, s = std::sqrt(1 - t * t);
            for (int j = 0; j < side; ++j) {
                const double psi = 2 * pi * (j + 0.5) / side;
                const dvec3 stretched{span.stretch.x * s * std::cos(psi), span.stretch.y * s * std::sin(psi),
                                      t};
                const double length = glm::length(stretched);
                dvec3 h = stretched / length;
                h.z *= span.flip;
                facets[static_cast<std::size_t>(i * side + j)] = {
                    h, density(h) * patch / (length * length * length)};
            }
        }
        return MomentPyramid(side, facets);
    }

    std::shared_ptr<const LobeModel> base_;
    Modulation modulation_;
    double peak_ = 1;
    std::vector<MomentPyramid> pyramids_;
};

}  // namespace

std::shared_ptr<const LobeModel> make_painted_lobe(const PaintedLobe& lobe,
                                                   const std::optional<Modulation>& modulation) {
    return std::make_shared<Painted>(lobe, modulation);
}

std::shared_ptr<const LobeModel> make_modulated_lobe(std::shared_ptr<const LobeModel> base,
                                                     const Modulation& modulation) {
    return std::make_shared<Modulated>(std::move(base), modulation);
}

}  // namespace nacre
