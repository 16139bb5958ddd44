#include "core/model/picture_lobe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include "core/model/disk.h"
#include "core/model/lobe_densities.h"
#include "core/model/moment_pyramid.h"
#include "core/model/shading.h"

namespace nacre {
namespace {

using std::numbers::pi;

// A picture as the shader reads it.
class PictureReader {
  public:
    explicit PictureReader(const Picture& picture) : raster_(picture.raster) {
        shading_.data = raster_->values.data();
    }
    double operator()(dvec3 h) const { return shading_.picture_value(h, 0, raster_->width); }

  private:
    std::shared_ptr<const Raster> raster_;
    Shading<double> shading_;
};

// 1 - strength + strength * picture.
class ModulationFactor {
  public:
    explicit ModulationFactor(const Modulation& modulation)
        : strength_(modulation.strength), picture_(modulation.image) {
        const std::vector<float>& values = modulation.image.raster->values;
        const double brightest = *std::max_element(values.begin(), values.end());
        peak_ = 1 - strength_ + strength_ * std::max(brightest, 0.0);
    }
    double operator()(dvec3 h) const { return 1 - strength_ + strength_ * picture_(h); }
    double peak() const { return peak_; }

  private:
    double strength_;
    PictureReader picture_;
    double peak_ = 1;
};

// p is bilinear between texel centres; the set of facets that stands for it has at least 256 of them a side.
class Painted final : public LobeModel {
  public:
    Painted(const PaintedLobe& lobe, const std::optional<Modulation>& modulation)
        : raster_(lobe.image.raster), picture_(lobe.image), modulation_(modulation) {
        while (raster_->width * finer_ < 256) finer_ *= 2;
        cells_ = raster_->width * finer_;
        if (modulation) factor_.emplace(*modulation);
        pyramid_ = std::make_unique<const MomentPyramid>(
            static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells_))), facet_at());
    }

    // The same lobe with another raster of the same size, which differs within `part`, in texels.
    Painted(const Painted& before, const Picture& image, const MomentPyramid::Part& part)
        : raster_(image.raster),
          picture_(image),
          modulation_(before.modulation_),
          factor_(before.factor_),
          finer_(before.finer_),
          cells_(before.cells_),
          pyramid_(
              std::make_unique<const MomentPyramid>(before.pyramid_->changed(facets_of(part), facet_at()))) {}

    // What one texel changes when p is bilinear: itself and, between centres, its neighbours.
    MomentPyramid::Part facets_of(const MomentPyramid::Part& texels) const {
        const int reach = finer_ == 1 ? 0 : 1;
        return {std::max(texels.row_begin - reach, 0) * finer_,
                std::min(texels.row_end + reach, raster_->height) * finer_,
                std::max(texels.column_begin - reach, 0) * finer_,
                std::min(texels.column_end + reach, raster_->width) * finer_};
    }

    Facet facet(int row, int column) const {
        if (row >= cells_ || column >= cells_) return {};
        const dvec2 at = grid_point(row + 0.5, column + 0.5);
        if (glm::dot(at, at) >= 1) return {};
        const dvec3 h = disk_direction(at);
        double p = 0;
        if (finer_ == 1) {
            p = static_cast<double>(raster_->values[static_cast<std::size_t>(row * cells_ + column)]);
            if (factor_) p *= (*factor_)(h);
        } else {
            p = density(h);
        }
        return {h, p * (2 * (2.0 / cells_) * (2.0 / cells_))};
    }

    const Raster& raster() const { return *raster_; }
    const std::optional<Modulation>& modulation() const { return modulation_; }

    double density(dvec3 h) const override {
        const double p = picture_(h);
        return factor_ ? p * (*factor_)(h) : p;
    }
    void densities(const DirectionColumns& h, double* p) const override {
        if (factor_) return LobeModel::densities(h, p);
        lobe_densities({Shading<double>::LOBE_PAINTED, {}, raster_->values.data(), raster_->width}, h, p);
    }
    double mass() const override { return pyramid_->mass(); }
    Area area(dvec3 k) const override { return pyramid_->area(k); }
    double projected_area(dvec3 k) const override { return pyramid_->projected_area(k); }
    dvec3 mean() const override { return pyramid_->mean(); }
    std::vector<LobeSpan> spans() const override { return {}; }
    std::vector<LobeSpan> domains() const override { return {LobeSpan{}}; }
    std::vector<Facet> facets(std::size_t count) const override { return pyramid_->facets(count); }

    // A cell by descent, then a place in it by rejection; p is bilinear on the quarters of a cell, so that
    // its corners, edges' middles and centre bound it.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const std::size_t index = pyramid_->sample_visible(k, random);
        const std::size_t side = std::bit_ceil(static_cast<std::size_t>(cells_));
        const double row = static_cast<double>(index / side), column = static_cast<double>(index % side);
        double peak = 0;
        for (int i = 0; i < 9; ++i) {
            const dvec2 at = grid_point(row + 0.5 * (i / 3), column + 0.5 * (i % 3));
            peak = std::max(peak, density(disk_direction(at * std::min(1.0, (1 - 1e-12) / glm::length(at)))));
        }
        const double reach = 4.0 / cells_;
        const double seen = glm::dot(k, disk_direction(grid_point(row + 0.5, column + 0.5))) + reach;
        for (;;) {
            const dvec2 at = grid_point(row + uniform_random(random), column + uniform_random(random));
            if (glm::dot(at, at) >= 1) continue;
            const dvec3 h = disk_direction(at);
            if (uniform_random(random) * peak * seen < density(h) * glm::dot(k, h)) return h;
        }
    }

  private:
    dvec2 grid_point(double row, double column) const {
        return {2 * column / cells_ - 1, 1 - 2 * row / cells_};
    }

    MomentPyramid::FacetAt facet_at() const {
        return [this](int row, int column) { return facet(row, column); };
    }

    std::shared_ptr<const Raster> raster_;
    PictureReader picture_;
    std::optional<Modulation> modulation_;
    std::optional<ModulationFactor> factor_;
    int finer_ = 1;  // facets a side of a texel
    int cells_ = 0;  // facets a side
    std::unique_ptr<const MomentPyramid> pyramid_;
};

// The smallest part that holds every texel in which two rasters of one size differ.
MomentPyramid::Part difference(const Raster& a, const Raster& b) {
    MomentPyramid::Part part{a.height, 0, a.width, 0};
    const auto same = [](const float* x, const float* y, int count) {
        return std::memcmp(x, y, static_cast<std::size_t>(count) * sizeof(float)) == 0;
    };
    for (int row = 0; row < a.height; ++row) {
        const float* x = &a.values[static_cast<std::size_t>(row * a.width)];
        const float* y = &b.values[static_cast<std::size_t>(row * a.width)];
        if (same(x, y, a.width)) continue;
        part.row_begin = std::min(part.row_begin, row);
        part.row_end = row + 1;
        int first = 0, last = a.width;
        while (same(x + first, y + first, 1)) ++first;
        while (same(x + last - 1, y + last - 1, 1)) --last;
        part.column_begin = std::min(part.column_begin, first);
        part.column_end = std::max(part.column_end, last);
    }
    return part;
}

// The base lobe's own coordinates carry the facets, so that a narrow lobe is resolved whatever the picture's
// size.
class Modulated final : public LobeModel {
  public:
    Modulated(std::shared_ptr<const LobeModel> base, const Modulation& modulation)
        : base_(std::move(base)), factor_(modulation) {
        for (const LobeSpan& span : base_->spans()) pyramids_.push_back(make_pyramid(span));
    }

    double density(dvec3 h) const override { return base_->density(h) * factor_(h); }

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

    double projected_area(dvec3 k) const override {
        double sum = 0;
        for (const MomentPyramid& pyramid : pyramids_) sum += pyramid.projected_area(k);
        return sum;
    }

    dvec3 mean() const override {
        dvec3 sum{0};
        for (const MomentPyramid& pyramid : pyramids_) sum += pyramid.mean();
        return sum;
    }

    std::vector<LobeSpan> spans() const override { return {}; }
    std::vector<LobeSpan> domains() const override { return base_->domains(); }

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
            if (uniform_random(random) * factor_.peak() < factor_(h)) return h;
        }
    }

  private:
    static constexpr int side = 256;

    MomentPyramid make_pyramid(const LobeSpan& span) const {
        const double patch = 2 * pi / side / side * span.stretch.x * span.stretch.y;
        return MomentPyramid(side, [&](int i, int j) {
            const double t = (i + 0.5) / side, s = std::sqrt(1 - t * t);
            const double psi = 2 * pi * (j + 0.5) / side;
            const dvec3 stretched{span.stretch.x * s * std::cos(psi), span.stretch.y * s * std::sin(psi), t};
            const double length = glm::length(stretched);
            dvec3 h = stretched / length;
            h.z *= span.flip;
            return Facet{h, density(h) * patch / (length * length * length)};
        });
    }

    std::shared_ptr<const LobeModel> base_;
    ModulationFactor factor_;
    std::vector<MomentPyramid> pyramids_;
};

}  // namespace

std::shared_ptr<const LobeModel> make_painted_lobe(const PaintedLobe& lobe,
                                                   const std::optional<Modulation>& modulation) {
    return std::make_shared<Painted>(lobe, modulation);
}

std::optional<Repaint> repaint(const LobeModel& before, const Layer& after) {
    const auto* lobe = dynamic_cast<const Painted*>(&before);
    const auto* painted = std::get_if<PaintedLobe>(&after.lobe);
    if (!lobe || !painted || lobe->modulation() != after.modulation) return {};
    const Raster& raster = *painted->image.raster;
    if (lobe->raster().width != raster.width) return {};
    const MomentPyramid::Part texels = difference(lobe->raster(), raster);
    auto repainted = std::make_shared<const Painted>(*lobe, painted->image, texels);
    Repaint result{repainted, {}};
    const MomentPyramid::Part part = lobe->facets_of(texels);
    for (int row = part.row_begin; row < part.row_end; ++row)
        for (int column = part.column_begin; column < part.column_end; ++column) {
            const Facet old = lobe->facet(row, column), now = repainted->facet(row, column);
            if (now.mass != old.mass) result.changes.push_back({now.h, now.mass - old.mass});
        }
    return result;
}

std::shared_ptr<const LobeModel> make_modulated_lobe(std::shared_ptr<const LobeModel> base,
                                                     const Modulation& modulation) {
    return std::make_shared<Modulated>(std::move(base), modulation);
}

}  // namespace nacre
