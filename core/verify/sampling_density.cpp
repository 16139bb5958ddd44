#include "core/verify/sampling_density.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <vector>

#include "core/bake/bake.h"
#include "core/bake/bounce_directions.h"
#include "core/bake/brdf.h"
#include "core/model/span_facet.h"
#include "core/verify/direction_bins.h"
#include "core/verify/effort.h"
#include "core/verify/facet_ways.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

constexpr double seconds = 8;  // of the processor; no fewer than least_directions
constexpr int least_directions = 3;
constexpr int samples = 16384;       // from each
constexpr int facets_max = 1 << 16;  // of all lobes together
constexpr int cosine_points = 1 << 14;
constexpr int bins_max = 128;
constexpr double least_expected = 5;  // in a bin

// All facets above k1's horizon, weighed by what k1 sees of them: they add up to 1. None where it sees none.
std::vector<Facet> visible_facets(const FacetDistribution& distribution, dvec3 k1) {
    std::vector<Facet> facets;
    double sum = 0;
    auto add = [&](const PlacedLobe& placed, const Facet& facet) {
        const dvec3 h = placed.frame * facet.h;
        const double seen = placed.scale * facet.mass * glm::dot(h, k1);
        if (!(seen > 0)) return;
        facets.push_back({h, seen});
        sum += seen;
    };
    const std::size_t count = facets_max / distribution.lobes().size();
    for (const PlacedLobe& placed : distribution.lobes()) {
        for (const Facet& facet : placed.lobe->facets(count)) add(placed, facet);
        const std::vector<LobeParameterization> spans = placed.lobe->spans();
        for (const LobeParameterization& span : spans) {
            const int side =
                static_cast<int>(std::sqrt(static_cast<double>(count) / static_cast<double>(spans.size())));
            for (int i = 0; i < side * side; ++i)
                add(placed, span_facet(*placed.lobe, span, side, i / side, i % side));
        }
    }
    for (Facet& facet : facets) facet.mass /= sum;
    return facets;
}

// Shares of the pdf at k1. Facets in each way and cosine all cover what the others miss: a point's share is
// the pdf over the density of all points there (the balance heuristic, Veach & Guibas 1995).
std::vector<DirectionShare> shares_at(const Brdf& brdf, dvec3 k1) {
    const Shading<double>& shading = brdf.tables().shading;
    const std::vector<FacetWay> ways = facet_ways(brdf.tables(), k1);
    const bool with_cosine = brdf.cosine_probability() > 0;
    std::vector<DirectionShare> shares;
    auto add = [&](dvec3 k2, double points) {
        if (!(k2.z > 0)) return;
        double density = with_cosine ? cosine_density(k2) : 0;
        for (const FacetWay& way : ways) density += way.density(shading, k2);
        if (density > 0) shares.push_back({k2, points * brdf.pdf(k1, k2) / density});
    };
    for (const FacetWay& way : ways)
        for (const Facet& facet : visible_facets(*way.distribution, way.k1))
            add(way.end(shading, facet.h), facet.mass);
    if (with_cosine)
        for (const dvec3 k : even_directions(cosine_points)) add(k, 1.0 / cosine_points);
    return shares;
}

// What is expected and what came, bin by bin; a bin with little joins the next.
class Comparison {
  public:
    // `uncertainty` is the variance of `expected`.
    void add(double expected, double uncertainty, double observed) {
        expected_ += expected;
        uncertainty_ += uncertainty;
        observed_ += observed;
        if (expected_ < least_expected) return;
        const double off = observed_ - expected_;
        statistic_ += off * off / (expected_ + uncertainty_);
        ++bins_;
        expected_ = uncertainty_ = observed_ = 0;
    }

    int bins() const { return bins_; }

    // -log10 of the probability of this or worse. What is left over must not hold more than it may.
    double surprise() const {
        double statistic = statistic_;
        int bins = bins_;
        const double over = observed_ - expected_;
        if (over > 0) {
            statistic += over * over / (std::max(expected_, 1.0) + uncertainty_);
            ++bins;
        }
        if (bins == 0) return 0;
        const boost::math::chi_squared distribution(bins);
        return -std::log10(boost::math::cdf(boost::math::complement(distribution, statistic)));
    }

  private:
    double expected_ = 0, uncertainty_ = 0, observed_ = 0, statistic_ = 0;
    int bins_ = 0;
};

Comparison compare_at(const Brdf& brdf, dvec3 k1, const DirectionSource& source, Random random,
                      const std::stop_token& stop) {
    const Tables& tables = brdf.tables();
    // The pdf reads g from the tables, samples follow p itself.
    double slack = 0;
    for (const FacetWay& way : facet_ways(tables, k1)) {
        if (way.distribution != tables.distribution.get()) continue;
        const double read = tables.shading.projected_area(way.k1, tables.shading.table_spot(way.k1));
        if (read > 0) slack = std::max(slack, std::fabs(way.g / read - 1));
    }
    std::vector<DirectionShare> shares = shares_at(brdf, k1);
    double all = 0, all_variance = 0;
    for (const DirectionShare& share : shares) {
        all += share.share;
        all_variance += share.share * share.share;
    }
    const int most = std::clamp(static_cast<int>(all * samples / (2 * least_expected)), 1, bins_max);
    const DirectionBins bins(std::move(shares), most);
    std::vector<double> observed(bins.count(), 0.0);
    double lost = 0;
    for (int i = 0; i < samples; ++i) {
        if (i % 256 == 0 && stop.stop_requested()) throw BakeCancelled();
        if (const std::optional<dvec3> k2 = source(random))
            observed[bins.index(*k2)] += 1;
        else
            lost += 1;
    }
    auto variance = [&](double share, double of_parts) {
        return double{samples} * samples * (of_parts + slack * slack * share * share);
    };
    Comparison comparison;
    for (std::size_t bin = 0; bin < bins.count(); ++bin)
        comparison.add(samples * bins.share(bin), variance(bins.share(bin), bins.variance(bin)),
                       observed[bin]);
    comparison.add(samples * std::max(1 - all, 0.0), variance(all, all_variance), lost);
    return comparison;
}

}  // namespace

SamplingDensity measure_sampling_density(const std::shared_ptr<const Tables>& tables, std::stop_token stop,
                                         const std::function<DirectionSource(dvec3 k1)>& source_at,
                                         int directions) {
    const Brdf brdf(tables);
    const std::vector<dvec3> probes = probe_directions(directions);
    std::vector<Comparison> parts(probes.size());
    SamplingDensity result{.samples = samples};
    result.directions = visit_within(seconds, directions, least_directions, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        const dvec3 k1 = probes[at];
        const Random random(at + 1);
        if (source_at) {
            parts[at] = compare_at(brdf, k1, source_at(k1), random, stop);
            return;
        }
        const BrdfSampler sampler(brdf, k1);
        auto draw = [&](Random& from) {
            const std::optional<BrdfSample> sample = sampler(from);
            return sample ? std::optional<dvec3>(sample->k2) : std::nullopt;
        };
        parts[at] = compare_at(brdf, k1, draw, random, stop);
    });
    parts.resize(static_cast<std::size_t>(result.directions));
    for (const Comparison& part : parts) {
        result.surprise = worse_error(result.surprise, part.surprise() - std::log10(result.directions));
        result.bins += part.bins();
    }
    return result;
}

}  // namespace nacre
