// A rule of integration over the facets of a lobe that holds a picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stop_token>
#include <vector>

#include "core/bake/bake.h"
#include "core/model/facet_distribution.h"
#include "core/model/quadrature.h"

namespace nacre {

// However rough p is, what it is integrated with is smooth but for a few lines. So the disk of the lobe's own
// coordinates is a quadtree of boxes, and each holds the weights with which the 4 x 4 points of a Gauss grid
// give the integral of p times any bicubic: its moments, exact for p. A box serves where its four children
// agree with it, and is split where they do not. Where a child is empty too: its points lie beside p, where
// all of them may agree on what p never meets.
class PictureRule {
  public:
    // The lobe has no smooth form; it is kept as a reference.
    explicit PictureRule(const PlacedLobe& placed);

    // Of f(h) times p, f giving Values<4> for any h of the surface's frame. `tolerance` is absolute, of every
    // value. Throws BakeCancelled soon after a stop is requested.
    template <class Function>
    Values<4> integrate(const Function& f, double tolerance, const std::stop_token& stop) const {
        Values<4> sum{};
        for (const Domain& domain : domains_)
            for (std::size_t box = 0; box < boxes_at(first_level); ++box)
                add(sum, over(domain, first_level, box, at(domain, first_level, box, f), f, tolerance, stop));
        return sum;
    }

  private:
    static constexpr int first_level = 5, sparse_level = 7, last_level = 8;
    static constexpr std::size_t points = 4, weights = points * points;

    // One hemisphere of the lobe: h' is seen on the equal-area disk, and boxes lie in Morton order.
    struct Domain {
        LobeParameterization span;
        std::array<std::vector<double>, last_level + 1> weight;
    };

    static std::size_t boxes_at(int level) { return std::size_t{1} << (2 * level); }
    static void add(Values<4>& sum, const Values<4>& values) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
    }

    void add_point(const Facet& facet);
    static void add_up(Domain& domain);
    dvec3 node(const Domain& domain, int level, std::size_t box, std::size_t point) const;

    static const double* weights_of(const Domain& domain, int level, std::size_t box) {
        return &domain.weight[static_cast<std::size_t>(level)][box * weights];
    }
    static bool is_empty(const double* weight) {
        return std::all_of(weight, weight + weights, [](double w) { return w == 0; });
    }

    template <class Function>
    Values<4> at(const Domain& domain, int level, std::size_t box, const Function& f) const {
        Values<4> sum{};
        const double* weight = weights_of(domain, level, box);
        if (is_empty(weight)) return sum;
        for (std::size_t i = 0; i < weights; ++i) {
            const Values<4> values = f(node(domain, level, box, i));
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += weight[i] * values[c];
        }
        return sum;
    }

    // `coarse`: what the box itself gives.
    template <class Function>
    Values<4> over(const Domain& domain, int level, std::size_t box, const Values<4>& coarse,
                   const Function& f, double tolerance, const std::stop_token& stop) const {
        if (stop.stop_requested()) throw BakeCancelled();
        if (is_empty(weights_of(domain, level, box))) return {};
        std::array<Values<4>, 4> parts;
        Values<4> fine{};
        bool sparse = false;
        for (std::size_t i = 0; i < 4; ++i) {
            add(fine, parts[i] = at(domain, level + 1, 4 * box + i, f));
            sparse = sparse || is_empty(weights_of(domain, level + 1, 4 * box + i));
        }
        double error = 0;
        for (std::size_t c = 0; c < fine.size(); ++c)
            error = std::fmax(error, std::fabs(fine[c] - coarse[c]));
        // Lines where f bends pass about 2^level boxes.
        const bool trusted = !sparse || level >= sparse_level;
        if (level + 1 == last_level || (trusted && error <= tolerance * std::exp2(-level))) return fine;
        fine = {};
        for (std::size_t i = 0; i < 4; ++i)
            add(fine, over(domain, level + 1, 4 * box + i, parts[i], f, tolerance, stop));
        return fine;
    }

    const PlacedLobe& placed_;
    std::vector<Domain> domains_;
};

}  // namespace nacre
