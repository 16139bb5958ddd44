#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "core/model/facet_lobe.h"
#include "core/model/modulated_envelope.h"
#include "core/model/moment_pyramid.h"
#include "core/model/picture_lobe.h"
#include "core/model/picture_reader.h"
#include "core/model/span_facet.h"

namespace nacre {
namespace {

// Where a picture is the same all over a part of it.
class EvenParts {
  public:
    explicit EvenParts(const Raster& picture)
        : side_(picture.width),
          sums_(static_cast<std::size_t>(side_ + 1) * static_cast<std::size_t>(side_ + 1)) {
        const auto value = [&](int row, int column) {
            return picture
                .values[static_cast<std::size_t>(std::min(row, side_ - 1)) * static_cast<std::size_t>(side_) +
                        static_cast<std::size_t>(std::min(column, side_ - 1))];
        };
        for (int row = 0; row < side_; ++row)
            for (int column = 0; column < side_; ++column) {
                const float here = value(row, column);
                const bool steps = value(row + 1, column) != here || value(row, column + 1) != here;
                sums_[index(row + 1, column + 1)] = (steps ? 1 : 0) + sums_[index(row, column + 1)] +
                                                    sums_[index(row + 1, column)] - sums_[index(row, column)];
            }
    }

    // Whether all texels are that are read between two corners of a rectangle on the disk.
    bool is_even(dvec2 low, dvec2 high) const {
        const auto texel = [&](double along) { return (along + 1) / 2 * side_ - 0.5; };
        const int left = static_cast<int>(std::floor(texel(low.x))),
                  right = static_cast<int>(std::ceil(texel(high.x)));
        const int top = static_cast<int>(std::floor(texel(-high.y))),
                  bottom = static_cast<int>(std::ceil(texel(-low.y)));
        if (left < 0 || top < 0 || right >= side_ || bottom >= side_) return false;
        const int steps = sums_[index(bottom + 1, right + 1)] - sums_[index(top, right + 1)] -
                          sums_[index(bottom + 1, left)] + sums_[index(top, left)];
        return steps == 0;
    }

  private:
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_ + 1) +
               static_cast<std::size_t>(column);
    }

    int side_;
    std::vector<int> sums_;  // of the steps above and left of a texel's corner
};

// The base lobe's own coordinates carry the facets, so that a narrow lobe is resolved whatever the picture's
// size.
class Modulated final : public FacetLobe {
  public:
    Modulated(std::shared_ptr<const LobeModel> base, const Modulation& modulation, Fineness fineness)
        : base_(std::move(base)),
          factor_(modulation),
          even_parts_(extended_past_rim(*modulation.image.raster)),
          side_(fineness == Fineness::bake ? 128 : 512),
          pieces_a_texel_(fineness == Fineness::bake ? 2 : 6) {
        for (const LobeParameterization& span : base_->spans()) pyramids_.push_back(make_pyramid(span));
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

    std::vector<LobeParameterization> domains() const override { return base_->domains(); }

    std::vector<Facet> facets(std::size_t count) const override {
        std::vector<Facet> all;
        for (const MomentPyramid& pyramid : pyramids_) {
            const std::vector<Facet> part = pyramid.facets(count);
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    }

    void visit_leaves(const std::function<void(const LeafBlock&)>& visit) const override {
        for (const MomentPyramid& pyramid : pyramids_) pyramid.visit_leaves(visit);
    }

    void visit_points(const std::function<void(const Facet&)>& visit) const override {
        for (const LobeParameterization& span : base_->spans())
            for (int row = 0; row < side_; ++row)
                for (int column = 0; column < side_; ++column)
                    visit_cell(span, row, column, [&](dvec3 h, double mass) {
                        if (mass > 0) visit({h, mass});
                    });
    }

    dvec3 sample_visible(dvec3 k, Random& random) const override {
        for (;;) {
            const dvec3 h = base_->sample_visible(k, random);
            if (uniform_random(random) * factor_.peak() < factor_(h)) return h;
        }
    }

    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_modulated_envelope(base_->envelope(), factor_);
    }

  private:
    static constexpr double faintest = 1e-9;  // of p, where its mean is 1
    static constexpr int pieces_max = 16;     // of a cell around the axis

    // Two of Gauss's points in each of `pieces` pieces of [0, 1].
    static double place(int i, int pieces) {
        const double off = (i % 2 == 0 ? -0.5 : 0.5) * std::numbers::inv_sqrt3;
        const int piece = i / 2;
        return (piece + 0.5 + off) / pieces;
    }

    // Pieces no wider than the picture's texels.
    int pieces_between(dvec3 a, dvec3 b) const {
        if (a.z < 0 && b.z < 0) return 1;
        const double pieces =
            pieces_a_texel_ * 0.5 * factor_.side() * glm::length(disk_point(a) - disk_point(b));
        return std::clamp(static_cast<int>(std::ceil(pieces)), 1, pieces_max);
    }

    // The ends of a piece of the great circle at an azimuth, in t; it is cut where p has a corner: at the
    // lobe's own, and where the circle, on the disk a straight line from its middle, crosses the lines
    // between middles of texels.
    void cut_line(const LobeParameterization& span, dvec2 azimuth, bool even,
                  std::vector<double>& cuts) const {
        const double low = cuts.front(), high = cuts.back();
        const auto add = [&](double t) {
            if (t > low && t < high) cuts.push_back(t);
        };
        for (const double angle : span.breaks) add(std::cos(angle));
        if (!even) cut_at_texels(span, azimuth, low, high, add);
        std::sort(cuts.begin(), cuts.end());
    }

    template <class Add>
    void cut_at_texels(const LobeParameterization& span, dvec2 azimuth, double low, double high,
                       const Add& add) const {
        const dvec2 along = span.stretch * azimuth;
        const double stretch = glm::length(along);
        const auto radius = [&](double t) {  // of the disk: 1 - h.z = r^2
            const double rise = stretch * std::sqrt(std::max(1 - t * t, 0.0));
            return std::sqrt(std::max(1 - t / std::hypot(t, rise), 0.0));
        };
        const double from = radius(high), to = radius(low);
        const int side = factor_.side();
        for (const double slope : {std::fabs(along.x) / stretch, std::fabs(along.y) / stretch}) {
            if (slope < 1e-12 || span.flip < 0) continue;
            // Middles lie at (2 i + even)/side.
            const double even = side % 2 == 0 ? 1 : 0;
            for (double i = std::ceil((from * slope * side - even) / 2); 2 * i + even < to * slope * side;
                 ++i) {
                const double r = (2 * i + even) / side / slope, z = 1 - r * r;
                if (r > 0 && z > 0) add(stretch * z / std::sqrt(stretch * stretch * z * z + 1 - z * z));
            }
        }
    }

    // Whether the picture is the same all over a cell.
    bool is_even(const LobeParameterization& span, int row, int column) const {
        dvec2 low(HUGE_VAL), high(-HUGE_VAL);
        for (const int t : {row, row + 1})
            for (const double c : {0.0, 0.5, 1.0}) {
                const dvec3 h = span_point(span, static_cast<double>(t) / side_,
                                           unit_vector(2 * std::numbers::pi * (column + c) / side_))
                                    .h;
                if (!(h.z > 0)) return false;
                low = glm::min(low, disk_point(h));
                high = glm::max(high, disk_point(h));
            }
        const dvec2 bulge = 0.3 * (high - low);  // its sides are bent
        return even_parts_.is_even(low - bulge, high + bulge);
    }

    // Of a lobe without corners.
    bool next_to_nothing(const LobeParameterization& span, const std::array<SpanPoint, 2>& corners) const {
        const double part = 2 * std::numbers::pi / base_->mass();
        return span.breaks.empty() && std::all_of(corners.begin(), corners.end(), [&](const SpanPoint& at) {
                   return base_->density(at.h) * at.solid_angle * part < faintest;
               });
    }

    // visit(its h, its mass) for the points of a cell.
    template <class Visit>
    void visit_cell(const LobeParameterization& span, int row, int column, const Visit& visit) const {
        const double turn = 2 * std::numbers::pi / side_;
        const double low = static_cast<double>(row) / side_, high = (row + 1.0) / side_;
        const auto corner = [&](double t, int c) { return span_point(span, t, unit_vector(c * turn)); };
        // A cell is broadest where it is farthest from the axis.
        const SpanPoint outer = corner(low, column);
        const bool faint = next_to_nothing(span, {outer, corner(high, column)});
        const bool even = faint || is_even(span, row, column);
        const int columns = even ? 1 : pieces_between(outer.h, corner(low, column + 1).h);
        std::vector<double> cuts;
        for (int j = 0; j < 2 * columns; ++j) {
            const dvec2 azimuth = unit_vector(turn * (column + place(j, columns)));
            cuts = {low, high};
            if (!faint) cut_line(span, azimuth, even, cuts);
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
                for (int point = 0; point < 2; ++point) {
                    const double length = cuts[i + 1] - cuts[i];
                    const SpanPoint at = span_point(span, cuts[i] + length * place(point, 1), azimuth);
                    visit(at.h, density(at.h) * at.solid_angle * turn * length / (4.0 * columns));
                }
        }
    }

    Facet cell(const LobeParameterization& span, int row, int column) const {
        Facet sum{dvec3{0}, 0};
        visit_cell(span, row, column, [&](dvec3 h, double mass) {
            sum.h += mass * h;
            sum.mass += mass;
        });
        if (sum.mass > 0) sum.h /= sum.mass;
        return sum;
    }

    // A cell is a box; a tent with its second moments is 1/sqrt(2) as wide, to either side.
    Spread spread_of(const LobeParameterization& span, double row, double column) const {
        const auto h = [&](double r, double c) {
            return span_point(span, std::clamp(r / side_, 0.0, 1.0),
                              unit_vector(2 * std::numbers::pi * c / side_))
                .h;
        };
        const double half = 0.5, part = 1 / std::numbers::sqrt2;
        Spread spread = spread_along(part * (h(row + half, column) - h(row - half, column)));
        spread += spread_along(part * (h(row, column + half) - h(row, column - half)));
        return spread;
    }

    MomentPyramid make_pyramid(const LobeParameterization& span) const {
        return MomentPyramid(
            side_, [&](int i, int j) { return cell(span, i, j); },
            [&](double row, double column) { return spread_of(span, row, column); });
    }

    std::shared_ptr<const LobeModel> base_;
    ModulationFactor factor_;
    EvenParts even_parts_;
    int side_;  // cells a side of a span
    int pieces_a_texel_;
    std::vector<MomentPyramid> pyramids_;
};

}  // namespace

std::shared_ptr<const LobeModel> make_modulated_lobe(std::shared_ptr<const LobeModel> base,
                                                     const Modulation& modulation, Fineness fineness) {
    return std::make_shared<Modulated>(std::move(base), modulation, fineness);
}

}  // namespace nacre
