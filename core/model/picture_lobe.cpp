#include "core/model/picture_lobe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/model/disk_quadrature.h"
#include "core/model/facet_lobe.h"
#include "core/model/lobe_densities.h"
#include "core/model/modulated_envelope.h"
#include "core/model/moment_pyramid.h"
#include "core/model/picture_envelope.h"
#include "core/model/picture_reader.h"
#include "core/model/texel_tents.h"

namespace nacre {
namespace {

TexelTents make_tents(int side, const std::optional<ModulationFactor>& factor) {
    if (!factor) return TexelTents(side);
    return {side, [&](dvec2 at) { return (*factor)(at); }, factor->side()};
}

// How many texels on the disk hold p, were it the same in each of them.
double texels_of(const Raster& raster) {
    double sum = 0, squares = 0;
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column) {
            if (!on_disk(raster.width, row, column)) continue;
            const auto value = static_cast<double>(
                raster.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width) +
                              static_cast<std::size_t>(column)]);
            sum += value;
            squares += value * value;
        }
    return squares > 0 ? sum * sum / squares : 0;
}

// Along each side of a texel, an odd number: as many as a wide p needs, and more where few texels hold all of
// it, whose R and g are then sums over few facets.
int tents_a_texel(const Raster& raster, Fineness fineness) {
    constexpr int least_side = 128, largest_side = 1024;  // tents a side
    constexpr double least_held = 4096;                   // tents that hold p
    const int more = fineness == Fineness::bake ? 1 : 2;
    int finer = 1;
    while (raster.width * finer < more * least_side) finer += 2;
    if (raster.width * (finer + 2) > largest_side) return finer;
    const double held = texels_of(raster);
    while (held > 0 && held * finer * finer < least_held && raster.width * (finer + 2) <= largest_side)
        finer += 2;
    return finer;
}

// p is bilinear between texel centres, so that it is the sum of tents; where there are few, each texel's is
// the sum of finer ones, whose middles lie on the texels' and evenly between.
class Painted final : public FacetLobe {
  public:
    Painted(const PaintedLobe& lobe, const std::optional<Modulation>& modulation, Fineness fineness)
        : given_(lobe.image.raster), picture_(*given_), modulation_(modulation) {
        finer_ = tents_a_texel(*given_, fineness);
        cells_ = given_->width * finer_;
        if (modulation) factor_.emplace(*modulation);
        tents_ = std::make_shared<const TexelTents>(make_tents(cells_, factor_));
        make_values();
        pyramid_ = std::make_unique<const MomentPyramid>(
            static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells_))), facet_at(), spread_at());
    }

    // The same lobe with another raster of the same size, which differs within `part`, in texels.
    Painted(const Painted& before, const std::shared_ptr<const Raster>& raster,
            const MomentPyramid::Part& part)
        : given_(raster),
          picture_(*raster),
          modulation_(before.modulation_),
          factor_(before.factor_),
          finer_(before.finer_),
          cells_(before.cells_),
          tents_(before.tents_) {
        make_values();
        pyramid_ = std::make_unique<const MomentPyramid>(
            before.pyramid_->changed(facets_of(part), facet_at(), spread_at()));
    }

    // What one texel changes: its tent and those that the disk's rim takes from it.
    MomentPyramid::Part facets_of(const MomentPyramid::Part& texels) const {
        const int reach = 2;
        return {std::max(texels.row_begin - reach, 0) * finer_,
                std::min(texels.row_end + reach, given_->height) * finer_,
                std::max(texels.column_begin - reach, 0) * finer_,
                std::min(texels.column_end + reach, given_->width) * finer_};
    }

    Facet facet(int row, int column) const {
        if (row >= cells_ || column >= cells_) return {};
        const double p = static_cast<double>(
            values_->values[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_) +
                            static_cast<std::size_t>(column)]);
        if (!(p > 0)) return {};
        const Facet tent = (*tents_)(row, column);
        return {tent.h, p * tent.mass};
    }

    const Raster& raster() const { return *given_; }
    int finer() const { return finer_; }
    const std::optional<Modulation>& modulation() const { return modulation_; }

    std::vector<int> sides() const {
        return factor_ ? std::vector{given_->width, factor_->side()} : std::vector{given_->width};
    }

    double density(dvec3 h) const override {
        const double p = picture_(h);
        return factor_ ? p * (*factor_)(h) : p;
    }
    void densities(const DirectionColumns& h, double* p) const override {
        if (factor_) return LobeModel::densities(h, p);
        lobe_densities({kind_index<Lobe, PaintedLobe>(), {}, picture_.raster()->values.data(), given_->width},
                       h, p);
    }
    double mass() const override { return pyramid_->mass(); }
    Area area(dvec3 k) const override { return pyramid_->area(k); }
    double projected_area(dvec3 k) const override { return pyramid_->projected_area(k); }
    dvec3 mean() const override { return pyramid_->mean(); }
    std::vector<LobeParameterization> domains() const override { return {LobeParameterization{}}; }
    std::vector<Facet> facets(std::size_t count) const override { return pyramid_->facets(count); }
    void visit_leaves(const std::function<void(const LeafBlock&)>& visit) const override {
        pyramid_->visit_leaves(visit);
    }

    void visit_points(const std::function<void(const Facet&)>& visit) const override {
        visit_disk(given_->width, factor_ ? factor_->side() : 0, [&](dvec2 at, double solid_angle) {
            const dvec3 h = disk_direction(at);
            const double p = picture_(at) * (factor_ ? (*factor_)(at) : 1);
            if (p > 0) visit({h, p * solid_angle});
        });
    }

    std::unique_ptr<const LobeEnvelope> envelope() const override {
        auto picture = make_picture_envelope(*values_);
        return factor_ ? make_modulated_envelope(std::move(picture), *factor_) : std::move(picture);
    }

    // A tent by descent, then a place under it. A tent of which k sees next to nothing may turn out to be
    // hidden whole: then another is drawn.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const std::size_t side = std::bit_ceil(static_cast<std::size_t>(cells_));
        for (;;) {
            const std::size_t index = pyramid_->sample_visible(k, random);
            const int row = static_cast<int>(index / side), column = static_cast<int>(index % side);
            const double most = glm::dot(k, (*tents_)(row, column).h) + 4 * tents_->reach();
            for (int trial = 0; trial < trials_max; ++trial) {
                const dvec2 at(place_under_tent(column, random), -place_under_tent(row, random));
                if (glm::dot(at, at) >= 1) continue;
                const dvec3 h = disk_direction(at);
                const double factor = factor_ ? (*factor_)(at) / factor_->peak() : 1;
                if (uniform_random(random) * most < factor * glm::dot(k, h)) return h;
            }
        }
    }

  private:
    static constexpr int trials_max = 10000;  // of places under a tent

    double middle_of(int index) const { return (2.0 * index + 1 - cells_) / cells_; }

    // Along one axis. A tent's outer half is flat where it is the outermost.
    double place_under_tent(int index, Random& random) const {
        const double ahead = uniform_random(random), back = uniform_random(random), off = ahead - back;
        const bool flat = (index == 0 && off < 0) || (index == cells_ - 1 && off > 0);
        return middle_of(index) +
               (flat ? std::copysign(0.5 * uniform_random(random), off) : off) * tents_->reach();
    }

    // What each tent is multiplied by.
    void make_values() {
        values_ = picture_.raster();
        if (finer_ == 1) return;
        auto finer = std::make_shared<Raster>(Raster{cells_, cells_, {}});
        finer->values.reserve(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
        for (int row = 0; row < cells_; ++row)
            for (int column = 0; column < cells_; ++column)
                finer->values.push_back(
                    static_cast<float>(picture_(dvec2(middle_of(column), -middle_of(row)))));
        values_ = std::move(finer);
    }

    MomentPyramid::FacetAt facet_at() const {
        return [this](int row, int column) { return facet(row, column); };
    }

    MomentPyramid::SpreadAt spread_at() const {
        return [this](double row, double column) {
            return spread_on_disk({2 * column / cells_ - 1, 1 - 2 * row / cells_}, tents_->reach());
        };
    }

    std::shared_ptr<const Raster> given_;
    PictureReader picture_;
    std::optional<Modulation> modulation_;
    std::optional<ModulationFactor> factor_;
    int finer_ = 1;  // tents a side of a texel, an odd number
    int cells_ = 0;  // tents a side
    std::shared_ptr<const TexelTents> tents_;
    std::shared_ptr<const Raster> values_;
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

}  // namespace

std::shared_ptr<const LobeModel> PaintedLobe::modulated_model(const std::optional<Modulation>& modulation,
                                                              Fineness fineness) const {
    return std::make_shared<Painted>(*this, modulation, fineness);
}

ShaderLobe PaintedLobe::shader() const {
    ScaledPicture picture = scaled_picture(*image.raster);
    return {.data_size = image.raster->width, .data = std::move(picture.texels), .unit = picture.unit};
}

std::vector<Facet> texel_facets(const Raster& raster, const std::optional<Modulation>& modulation) {
    const TexelTents tents =
        make_tents(raster.width, modulation ? std::make_optional<ModulationFactor>(*modulation)
                                            : std::optional<ModulationFactor>());
    std::vector<Facet> sums(raster.values.size());  // the moment for h
    const auto add = [&](std::size_t index, const Facet& tent, double part) {
        sums[index].h += part * tent.mass * tent.h;
        sums[index].mass += part * tent.mass;
    };
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column) {
            const Facet tent = tents(row, column);
            const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width) +
                               static_cast<std::size_t>(column);
            if (on_disk(raster.width, row, column)) {
                add(index, tent, 1);
                continue;
            }
            const TexelSources sources = texel_sources(raster.width, row, column);
            for (int i = 0; i < sources.count; ++i)
                add(sources.index[static_cast<std::size_t>(i)], tent, 1.0 / sources.count);
        }
    for (Facet& facet : sums)
        if (facet.mass > 0) facet.h /= facet.mass;
    return sums;
}

std::vector<int> picture_sides(const LobeModel& lobe) {
    const auto* painted = dynamic_cast<const Painted*>(&lobe);
    return painted ? painted->sides() : std::vector<int>();
}

std::shared_ptr<const LobeModel> repaint(const LobeModel& before, const Layer& after) {
    const auto* lobe = dynamic_cast<const Painted*>(&before);
    const auto* painted = std::get_if<PaintedLobe>(&after.lobe);
    if (!lobe || !painted || lobe->modulation() != after.modulation) return nullptr;
    const Raster& raster = *painted->image.raster;
    if (lobe->raster().width != raster.width) return nullptr;
    if (tents_a_texel(raster, Fineness::bake) != lobe->finer()) return nullptr;
    return std::make_shared<const Painted>(*lobe, painted->image.raster, difference(lobe->raster(), raster));
}

std::optional<std::vector<Facet>> painted_between(const LobeModel& before, const LobeModel& after) {
    const auto* old = dynamic_cast<const Painted*>(&before);
    const auto* now = dynamic_cast<const Painted*>(&after);
    if (!old || !now || old->raster().width != now->raster().width || old->finer() != now->finer() ||
        old->modulation() != now->modulation())
        return {};
    std::vector<Facet> changes;
    const MomentPyramid::Part part = old->facets_of(difference(old->raster(), now->raster()));
    for (int row = part.row_begin; row < part.row_end; ++row)
        for (int column = part.column_begin; column < part.column_end; ++column) {
            const Facet was = old->facet(row, column), is = now->facet(row, column);
            if (is.mass != was.mass) changes.push_back({is.h, is.mass - was.mass});
        }
    return changes;
}

}  // namespace nacre
