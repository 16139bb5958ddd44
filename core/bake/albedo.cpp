#include "core/bake/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/bake/tables.h"
#include "core/bake/worst_search.h"

namespace nacre {
namespace {

using std::numbers::pi;

void add(LayerAlbedo& sum, const LayerAlbedo& values) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
}

// The most cells of a lobe of facets, level by level.
constexpr std::array<std::size_t, 4> facet_counts = {200, 800, 3200, 12800};

// For a smooth lobe, over half of psi and over chi, level by level.
struct Order {
    const std::vector<QuadraturePoint>& psi;
    const std::vector<QuadraturePoint>& chi;
};

Order order(std::size_t level) {
    switch (level) {
        case 0:
            return {gauss_legendre<7>(), gauss_legendre<10>()};
        case 1:
            return {gauss_legendre<10>(), gauss_legendre<14>()};
        case 2:
            return {gauss_legendre<14>(), gauss_legendre<20>()};
        case 3:
            return {gauss_legendre<20>(), gauss_legendre<28>()};
        case 4:
            return {gauss_legendre<30>(), gauss_legendre<40>()};
        default:
            return {gauss_legendre<44>(), gauss_legendre<60>()};
    }
}

constexpr std::size_t orders = 6;

// A rule of more points is not refined further.
constexpr std::size_t most_points = 50000;

// Eq. 14 wants a cut where k1 and k2 stand in one plane: for the kink at 180 degrees, which is t(180 degrees)
// high, and for the peak of t at 0 where it is narrow. Where neither shows, all that is left to part at is
// the layer beside the horizon, which every correlated visibility has.
MaskingBends parted_as(const Shading<double>& shading) {
    constexpr double nothing = 1e-7, narrow = 0.2;
    const double width = shading.surface.masking_width, turned = pi / width;
    const bool plane = width < narrow || std::exp(-0.5 * turned * turned) > nothing;
    const MaskingBends bends = shading.kinds.masking_bends();
    return bends == MaskingBends::azimuth && !plane ? MaskingBends::horizon : bends;
}

// So many facets are summed at a time: they stay near the processor.
constexpr std::size_t batch = 512;

// The rule's points over one hemisphere of a smooth lobe, as facets: visit(some of them) again and again.
template <class Visit>
void walk_span(const GreatCircleQuadrature& walk, std::size_t level, MaskingBends bends, const Visit& visit) {
    const Order rule = order(level);
    const std::vector<double> azimuths = walk.azimuth_cuts(bends);
    std::vector<double> cuts;
    WalkPoints points;
    WeightedDirections facets;
    auto flush = [&] {
        walk.add_facets(points, facets);
        visit(std::as_const(facets));
        points.clear();
        facets.clear();
    };
    for (const QuadraturePoint& a : rule.psi) {
        for (std::size_t part = 0; part + 1 < azimuths.size(); ++part) {
            const double size = azimuths[part + 1] - azimuths[part];
            const GreatCircleQuadrature::Ray ray =
                walk.ray(walk.start() + pi * (azimuths[part] + size * a.x));
            walk.cuts(ray, bends, cuts);
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                const double chi = cuts[i], step = cuts[i + 1] - cuts[i];
                if (!(step > 0)) continue;
                points.add(ray.cosine, ray.sine, chi, step, rule.chi, pi * size * a.weight);
            }
            if (points.chi.size() >= batch) flush();
        }
    }
    flush();
}

// Directions by which a lobe's level is chosen.
constexpr int trials = 16;

// p has turned away where g is less than this part of N. Of directions near the horizon, at so many azimuths,
// those where it has are tried, at most so many.
constexpr double turned_part = 0.02;
constexpr int turned_azimuths = 48;
constexpr std::size_t turned_trials = 6;

// c from 0 to 1, crowded at grazing, azimuths all round. Where p has corners, every other direction is one
// that the lobe mirrors toward the horizon, as near to it as the lobe is wide: there the facets that send
// light up end between those corners, however narrow p is.
dvec3 trial_direction(const PlacedLobe& placed, int i) {
    const double part = i / (trials - 1.0), phi = 2 * pi * std::fmod(i * std::numbers::phi, 1.0);
    const auto at = [&](double c) {
        const double s = std::sqrt((1 - c) * (1 + c));
        return dvec3{s * std::cos(phi), s * std::sin(phi), c};
    };
    if (i % 2 == 1)
        for (const LobeParameterization& span : placed.lobe->spans()) {
            if (span.breaks.empty()) continue;
            const dvec3 up = at(std::min(2 * std::sin(span.breaks.back()), 1.0) * part);
            const dvec3 mirrored = 2 * glm::dot(up, placed.frame[2]) * placed.frame[2] - up;
            if (mirrored.z > 0) return mirrored;
        }
    return at(part * part);
}

// In columns that run to and fro, so that facets which are summed side by side read the tables at places near
// each other.
WeightedDirections columns_of(const std::vector<Facet>& facets) {
    constexpr int bands = 24;
    std::vector<std::pair<double, const Facet*>> places;
    for (const Facet& facet : facets) {
        const int band = static_cast<int>(0.5 * (facet.h.y + 1) * bands);
        places.emplace_back(4 * band + (band % 2 == 0 ? facet.h.x : -facet.h.x), &facet);
    }
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    WeightedDirections columns;
    for (const auto& [place, facet] : places) columns.add(facet->h, facet->mass);
    return columns;
}

double difference(const LayerAlbedo& a, const LayerAlbedo& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = worse_error(most, std::fabs(a[i] - b[i]));
    return most;
}

}  // namespace

AlbedoQuadrature::AlbedoQuadrature(const FacetDistribution& distribution, const Shading<double>& shading,
                                   int channels, double tolerance)
    : distribution_(distribution),
      shading_(shading),
      channels_(channels),
      levels_(distribution.lobes().size()) {
    make_facets(0);
    if (tolerance < std::numeric_limits<double>::infinity()) refine(tolerance);
}

AlbedoQuadrature AlbedoQuadrature::finer(double tolerance) const {
    AlbedoQuadrature rule = *this;
    rule.refine(tolerance);
    return rule;
}

void AlbedoQuadrature::refine(double tolerance) {
    // The lobes' errors add up, as they come.
    const double part = tolerance / std::sqrt(static_cast<double>(levels_.size()));
    const std::vector<dvec3> turned = turned_directions();
    for (std::size_t lobe = 0; lobe < levels_.size(); ++lobe) {
        std::vector<dvec3> facing;
        for (int i = 0; i < trials; ++i) facing.push_back(trial_direction(distribution_.lobes()[lobe], i));
        Levels& levels = levels_[lobe];
        levels.facing = choose_level(lobe, levels.facing, facing, part);
        levels.turned = std::max(levels.turned, levels.facing);
        if (!turned.empty()) levels.turned = choose_level(lobe, levels.turned, turned, part);
    }
}

bool AlbedoQuadrature::has_turned(double g1) const { return g1 < turned_part * distribution_.mean_cosine(); }

std::size_t AlbedoQuadrature::level(std::size_t lobe, double g1) const {
    const Levels& levels = levels_[lobe];
    return has_turned(g1) ? std::max(levels.turned, levels.facing) : levels.facing;
}

// Those of the smallest and of the largest g, and some between.
std::vector<dvec3> AlbedoQuadrature::turned_directions() const {
    std::vector<std::pair<double, dvec3>> found;
    for (int i = 0; i < turned_azimuths; ++i) {
        const double phi = 2 * pi * (i + 0.5) / turned_azimuths, c = i % 2 == 0 ? lowest_cosine : 0.02;
        const double s = std::sqrt((1 - c) * (1 + c));
        const dvec3 k{s * std::cos(phi), s * std::sin(phi), c};
        if (const double g = distribution_.projected_area(k); has_turned(g)) found.emplace_back(g, k);
    }
    std::ranges::stable_sort(found, {}, [](const auto& one) { return one.first; });
    std::vector<dvec3> directions;
    const std::size_t count = std::min(found.size(), turned_trials);
    for (std::size_t i = 0; i < count; ++i)
        directions.push_back(found[count == 1 ? 0 : i * (found.size() - 1) / (count - 1)].second);
    return directions;
}

void AlbedoQuadrature::make_facets(std::size_t level) {
    if (level < facets_.size()) return;
    facets_.emplace_back();
    for (const std::vector<Facet>& of_lobe : distribution_.facets(facet_counts[level]))
        facets_.back().push_back(columns_of(of_lobe));
}

std::size_t AlbedoQuadrature::choose_level(std::size_t lobe, std::size_t level,
                                           const std::vector<dvec3>& directions, double tolerance) {
    auto evaluate = [&](std::size_t at) {
        std::vector<LayerAlbedo> values;
        for (const dvec3 k : directions)
            values.push_back(over_lobe(lobe, at, k, distribution_.projected_area(k)));
        return values;
    };
    const bool smooth = !distribution_.lobes()[lobe].lobe->spans().empty();
    const std::size_t levels = smooth ? orders : facet_counts.size();
    std::vector<LayerAlbedo> now = evaluate(level);
    for (; level + 1 < levels; ++level) {
        if (!smooth) make_facets(level + 1);
        const std::vector<LayerAlbedo> finer = evaluate(level + 1);
        double worst = 0, squares = 0;
        for (std::size_t i = 0; i < finer.size(); ++i) {
            const double d = difference(now[i], finer[i]);
            worst = worse_error(worst, d);
            squares += d * d / static_cast<double>(finer.size());
        }
        if (worst <= 2 * tolerance && squares <= 0.25 * tolerance * tolerance) break;
        now = finer;
    }
    return level;
}

bool AlbedoQuadrature::refine_at(const std::vector<dvec3>& directions, double tolerance) {
    const double part = tolerance / std::sqrt(static_cast<double>(levels_.size()));
    auto points = [&] {
        std::size_t sum = 0;
        for (std::size_t lobe = 0; lobe < levels_.size(); ++lobe) {
            const std::size_t spans = distribution_.lobes()[lobe].lobe->spans().size();
            const std::size_t level = levels_[lobe].facing;
            sum += spans == 0 ? facet_counts[level]
                              : 2 * spans * order(level).psi.size() * order(level).chi.size();
        }
        return sum;
    };
    bool refined = false;
    for (std::size_t lobe = 0; lobe < levels_.size(); ++lobe) {
        const bool smooth = !distribution_.lobes()[lobe].lobe->spans().empty();
        const std::size_t finest = (smooth ? orders : facet_counts.size()) - 1;
        if (!smooth)
            for (std::size_t level = 0; level <= finest; ++level) make_facets(level);
        for (const dvec3 k : directions) {
            const double g = distribution_.projected_area(k);
            const LayerAlbedo best = over_lobe(lobe, finest, k, g);
            std::size_t& level = has_turned(g) ? levels_[lobe].turned : levels_[lobe].facing;
            while (level < finest && points() < most_points &&
                   difference(over_lobe(lobe, level, k, g), best) > part) {
                ++level;
                refined = true;
            }
        }
    }
    return refined;
}

AlbedoValues AlbedoQuadrature::operator()(dvec3 k1, double g1) const {
    return over_lobes(k1, g1, FirstBounce::leaves);
}

AlbedoValues AlbedoQuadrature::staying(dvec3 k1, double g1) const {
    return over_lobes(k1, g1, FirstBounce::stays);
}

AlbedoValues AlbedoQuadrature::over_lobes(dvec3 k1, double g1, FirstBounce which) const {
    const AlbedoLayout layout{channels_, shading_.kinds.tint};
    AlbedoValues sum{};
    for (std::size_t lobe = 0; lobe < levels_.size(); ++lobe)
        layout.add(over_lobe(lobe, level(lobe, g1), k1, g1, which), shading_.layers[lobe].tint, sum);
    return sum;
}

LayerAlbedo AlbedoQuadrature::over_lobe(std::size_t lobe, std::size_t level, dvec3 k1, double g1,
                                        FirstBounce which) const {
    const PlacedLobe& placed = distribution_.lobes()[lobe];
    if (placed.lobe->spans().empty())
        return sum_albedo(shading_, k1, g1, channels_, facets_[level][lobe], which);
    LayerAlbedo sum{};
    for (const LobeParameterization& span : placed.lobe->spans())
        walk_span(GreatCircleQuadrature(placed, span, k1), level, parted_as(shading_),
                  [&](const WeightedDirections& facets) {
                      add(sum, sum_albedo(shading_, k1, g1, channels_, facets, which));
                  });
    return sum;
}

}  // namespace nacre
