// H, N and g of a painted layer against integrals along lines across its disk.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/model/facet_distribution.h"
#include "core/paint/raster_texels.h"
#include "tests/core/random_directions.h"

namespace nacre::test {

struct TexelSums {
    double mass = 0;            // of the values, times solid angle
    dvec3 mean{0};              // of the same times h
    std::vector<double> areas;  // of the same times (h.k)+, for each view k
};

// Relatively: H and N are sums of whole facets; g is also of those that are seen in part.
inline constexpr double moment_tolerance = 1e-11, area_tolerance = 5e-8;

// A texel off the disk is read as the nearest on it, several as near as their mean.
inline double texel_read(const Raster& raster, int row, int column) {
    const auto value = [&](int r, int c) {
        return static_cast<double>(raster.values[static_cast<std::size_t>(r * raster.width + c)]);
    };
    if (holds_facets(texel_point(raster.width, row, column))) return value(row, column);
    double sum = 0;
    int nearest = 9, count = 0;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, raster.height - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, raster.width - 1); ++c) {
            const int distance = (r - row) * (r - row) + (c - column) * (c - column);
            if (!holds_facets(texel_point(raster.width, r, c)) || distance > nearest) continue;
            if (distance < nearest) sum = count = 0;
            nearest = distance;
            sum += value(r, c);
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

// One line across the disk, y = sin(t) from rim to rim, of a picture that is bilinear between its texels.
class TexelLine {
  public:
    TexelLine(const std::vector<double>& read, int side, const glm::dmat3& frame, double t)
        : read_(read), side_(side), frame_(frame), y_(std::sin(t)), half_(std::cos(t)) {
        const double row = std::clamp(0.5 * (1 - y_) * side - 0.5, 0.0, side - 1.0);
        row_ = std::min(static_cast<int>(row), side - 2), down_ = row - row_;
    }

    void add_to(TexelSums& sums, const std::vector<dvec3>& views, double weight) const {
        double begin = -half_;
        for (int i = 0; i <= side_; ++i) {
            const double end = i == side_ ? half_ : std::min((2.0 * i + 1 - side_) / side_, half_);
            if (!(end > begin)) continue;
            const int column = std::clamp(i - 1, 0, side_ - 2);
            if (value(0, column) + value(0, column + 1) + value(1, column) + value(1, column + 1) > 0)
                add_piece(sums, views, begin, end, weight);
            begin = end;
        }
    }

  private:
    double value(int down, int column) const {
        return read_[static_cast<std::size_t>((row_ + down) * side_ + column)];
    }
    dvec3 facet(double x) const { return frame_ * disk_direction({x, y_}); }
    double p(double x) const {
        const double at = std::clamp(0.5 * (1 + x) * side_ - 0.5, 0.0, side_ - 1.0);
        const int column = std::min(static_cast<int>(at), side_ - 2);
        const double s = at - column;
        return (value(0, column) * (1 - s) + value(0, column + 1) * s) * (1 - down_) +
               (value(1, column) * (1 - s) + value(1, column + 1) * s) * down_;
    }

    // Gauss's two points; visit(h, mass).
    template <class Visit>
    void over(double begin, double end, double weight, const Visit& visit) const {
        const double middle = 0.5 * (begin + end), off = 0.5 * (end - begin) * std::numbers::inv_sqrt3;
        for (const double x : {middle - off, middle + off})
            visit(facet(x), 0.5 * (end - begin) * weight * p(x));
    }

    void add_piece(TexelSums& sums, const std::vector<dvec3>& views, double begin, double end,
                   double weight) const {
        over(begin, end, weight, [&](dvec3 h, double mass) {
            sums.mass += mass;
            sums.mean += mass * h;
        });
        const dvec3 first = facet(begin), last = facet(end);
        for (std::size_t i = 0; i < views.size(); ++i) {
            const dvec3 k = views[i];
            double low = begin, high = end;
            const bool from = glm::dot(first, k) > 0, to = glm::dot(last, k) > 0;
            if (!from && !to) continue;
            for (int halving = 0; from != to && halving < 40; ++halving) {
                const double middle = 0.5 * (low + high);
                ((glm::dot(facet(middle), k) > 0) == from ? low : high) = middle;
            }
            over(from ? begin : low, to ? end : high, weight,
                 [&](dvec3 h, double mass) { sums.areas[i] += mass * glm::dot(h, k); });
        }
    }

    const std::vector<double>& read_;
    int side_;
    glm::dmat3 frame_;
    double y_, half_;
    int row_;
    double down_;
};

inline TexelSums texel_sums(const Raster& raster, const glm::dmat3& frame, const std::vector<dvec3>& views) {
    const int side = raster.width;
    std::vector<double> read, cuts = {-0.5 * std::numbers::pi, 0.5 * std::numbers::pi};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) read.push_back(texel_read(raster, row, column));
    // At the rows' middles, and where the rim meets those of columns.
    for (int i = 0; i < side; ++i) {
        const double middle = (2.0 * i + 1 - side) / side;
        for (const double t :
             {std::asin(middle), std::acos(std::fabs(middle)), -std::acos(std::fabs(middle))})
            cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    TexelSums sums;
    sums.areas.resize(views.size());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double middle = 0.5 * (cuts[i] + cuts[i + 1]), half = 0.5 * (cuts[i + 1] - cuts[i]);
        // Solid angles are twice the areas on the disk.
        for (const double t :
             {middle - half * std::numbers::inv_sqrt3, middle + half * std::numbers::inv_sqrt3})
            if (half > 0) TexelLine(read, side, frame, t).add_to(sums, views, 2 * half * std::cos(t));
    }
    return sums;
}

// `p` is of this layer alone.
inline void check_texel_sums(const FacetDistribution& p, const Layer& layer) {
    Random random(8);
    std::vector<dvec3> views;
    for (int i = 0; i < 6; ++i) views.push_back(random_direction(random));
    const TexelSums sums =
        texel_sums(*std::get<PaintedLobe>(layer.lobe).image.raster, layer_frame(layer), views);
    CHECK(glm::length(p.mean() - sums.mean / sums.mass) < moment_tolerance);
    CHECK(std::abs(p.mean_cosine() - sums.mean.z / sums.mass) < moment_tolerance);
    for (std::size_t i = 0; i < views.size(); ++i)
        CHECK(p.projected_area(views[i]) ==
              doctest::Approx(sums.areas[i] / sums.mass).epsilon(area_tolerance));
}

}  // namespace nacre::test
