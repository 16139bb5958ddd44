#include "core/model/span_envelope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/model/disk.h"
#include "core/model/span_facet.h"

namespace nacre {
namespace {

double sine_of(double cosine) { return std::sqrt(std::max(1 - cosine * cosine, 0.0)); }

// Cells between two heights and two azimuths of h'. Drawn evenly in t and along the chord from e0 to e1,
// whose azimuth psi moves by cross(e0, e1)/|e|^2.
class SpanEnvelope final : public LobeEnvelope {
  public:
    SpanEnvelope(const LobeModel& lobe, CellPeak peak)
        : lobe_(lobe), spans_(lobe.spans()), peak_(std::move(peak)) {}

    std::vector<FacetPatch> whole() const override {
        constexpr std::array<dvec2, 5> axes{dvec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
        std::vector<FacetPatch> patches;
        for (std::size_t span = 0; span < spans_.size(); ++span)
            for (std::size_t i = 0; i < 4; ++i) add(span, {0, 1, axes[i], axes[i + 1]}, patches);
        return patches;
    }

    // Halves by height or by azimuth.
    std::vector<Parts> splits(const FacetPatch& patch) const override {
        const SpanCell& cell = patch.cell;
        SpanCell inner = cell, outer = cell, left = cell, right = cell;
        const double rise = cell.t0 + cell.t1;
        inner.t0 = outer.t1 = rise / std::hypot(rise, sine_of(cell.t0) + sine_of(cell.t1));
        left.e0 = right.e1 = glm::normalize(cell.e0 + cell.e1);
        std::vector<Parts> ways(2);
        for (const SpanCell& part : {inner, outer}) add(patch.span, part, ways[0]);
        for (const SpanCell& part : {left, right}) add(patch.span, part, ways[1]);
        return ways;
    }

    // The mean of (h.k)+ over a Gaussian of width s is 0.28 s.
    double scale() const override {
        double least = 1;
        for (const LobeParameterization& span : spans_)
            least = std::min({least, span.stretch.x, span.stretch.y});
        return 0.28 * least;
    }

    Draw draw(const FacetPatch& patch, Random& random) const override {
        const SpanCell& cell = patch.cell;
        const dvec2 e = cell.e0 + uniform_random(random) * (cell.e1 - cell.e0);
        const double t = cell.t0 + uniform_random(random) * (cell.t1 - cell.t0), square = glm::dot(e, e);
        const SpanPoint at = span_point(spans_[patch.span], t, e / std::sqrt(square));
        return {at.h, lobe_.density(at.h) * at.solid_angle * least_square(cell) / (patch.peak * square)};
    }

  private:
    // Of |e|^2 along the chord, at its middle.
    static double least_square(const SpanCell& cell) { return 0.5 * (1 + glm::dot(cell.e0, cell.e1)); }

    void add(std::size_t span, const SpanCell& cell, std::vector<FacetPatch>& patches) const {
        FacetPatch patch;
        patch.span = span;
        patch.cell = cell;
        patch.peak = peak_(spans_[span], cell);
        const double cross = cell.e0.x * cell.e1.y - cell.e0.y * cell.e1.x;
        patch.mass = patch.peak * (cell.t1 - cell.t0) * cross / least_square(cell);
        if (!(patch.mass > 0)) return;
        enclose(patch);
        patches.push_back(patch);
    }

    // The cell lies in the cone of four directions: those of its corners, where at t0 the chord between two
    // of them is moved outward until it touches the circle. A is linear, so that its image lies in the
    // images' cone, and within a cap of less than a right angle that holds these.
    void enclose(FacetPatch& patch) const {
        const LobeParameterization& span = spans_[patch.span];
        const SpanCell& cell = patch.cell;
        const double outward = sine_of(cell.t0) / std::sqrt(least_square(cell));
        std::array<dvec3, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
            const dvec2 at = (i % 2 == 0 ? cell.e0 : cell.e1) * (i < 2 ? outward : sine_of(cell.t1));
            corners[i] = glm::normalize(dvec3{span.stretch * at, span.flip * (i < 2 ? cell.t0 : cell.t1)});
            patch.centre += corners[i];
        }
        patch.centre = glm::normalize(patch.centre);
        for (const dvec3 corner : corners)
            patch.radius = std::max(patch.radius, glm::length(corner - patch.centre));
        enclose_on_disk(patch, corners);
    }

    // Great circles bend on the disk, by a curvature of sqrt(2) at most, so that an arc lies within a fifth
    // of the square of its chord from that, where the chord is no longer than 0.6; no chord is longer than on
    // the sphere.
    static void enclose_on_disk(FacetPatch& patch, const std::array<dvec3, 4>& corners) {
        if (patch.radius > 0.3 || patch.centre.z < patch.radius) return;
        dvec2 low(HUGE_VAL), high(-HUGE_VAL);
        for (const dvec3 corner : corners) {
            low = glm::min(low, disk_point(corner));
            high = glm::max(high, disk_point(corner));
        }
        const double bend = 0.2 * glm::dot(high - low, high - low);
        patch.low = low - bend;
        patch.high = high + bend;
    }

    const LobeModel& lobe_;
    std::vector<LobeParameterization> spans_;
    CellPeak peak_;
};

}  // namespace

SquareBounds square_bounds(const SpanCell& cell) {
    const double a = cell.e0.x * cell.e0.x, b = cell.e1.x * cell.e1.x;
    return {std::min(a, b), std::max(a, b)};
}

// Linear in t^2 and in e.x^2: extreme at the corners.
StretchBounds stretch_bounds(const LobeParameterization& span, const SpanCell& cell) {
    const dvec2 square = span.stretch * span.stretch;
    StretchBounds bounds{HUGE_VAL, 0};
    for (const double t : {cell.t0, cell.t1})
        for (const dvec2 e : {cell.e0, cell.e1}) {
            const double value = t * t + (1 - t * t) * glm::dot(square, e * e);
            bounds = {std::min(bounds.low, value), std::max(bounds.high, value)};
        }
    return bounds;
}

std::unique_ptr<const LobeEnvelope> make_span_envelope(const LobeModel& lobe, CellPeak peak) {
    return std::make_unique<const SpanEnvelope>(lobe, std::move(peak));
}

}  // namespace nacre
