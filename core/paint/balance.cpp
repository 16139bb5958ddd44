#include "core/paint/balance.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "core/model/facet_distribution.h"
#include "core/model/picture_lobe.h"
#include "core/model/span_facet.h"
#include "core/paint/lobe_handles.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

constexpr double balanced_to = 1e-9;  // what is left of the mean normal along the surface
constexpr double least_left = 0.01;   // of a layer's share
constexpr int span_side = 64;         // facets a side that a lobe's covariance is summed over
constexpr int steps_max = 100;        // of Newton's method
constexpr double directed = 1e-6;     // a lobe whose mean normal is shorter has no direction to tilt

dvec2 along_surface(dvec3 h) { return {h.x, h.y}; }
glm::dmat2 square(dvec2 v) { return glm::outerProduct(v, v); }

// The logarithm of what the factor exp(lambda . h) multiplies a layer's area by, with its first and second
// derivatives: the layer's mean normal along the surface, and its covariance.
struct Tilted {
    double log_area = 0;
    dvec2 mean{0};
    glm::dmat2 covariance{0.0};
};

Tilted tilted(const std::vector<Facet>& facets, dvec2 lambda) {
    double largest = -HUGE_VAL;
    for (const Facet& facet : facets) largest = std::max(largest, glm::dot(lambda, along_surface(facet.h)));
    double before = 0, sum = 0;
    dvec2 first{0};
    glm::dmat2 second(0.0);
    for (const Facet& facet : facets) {
        const dvec2 h = along_surface(facet.h);
        const double mass = facet.mass * std::exp(glm::dot(lambda, h) - largest);
        before += facet.mass;
        sum += mass;
        first += mass * h;
        second += mass * square(h);
    }
    const dvec2 mean = first / sum;
    return {largest + std::log(sum / before), mean, second / sum - square(mean)};
}

// An enabled layer.
struct Member {
    std::size_t layer;
    double weight;              // share of all facets
    std::vector<Facet> texels;  // of a painted layer at a value of 1, in the surface's frame
    std::vector<Facet> facets;  // of a painted layer, those of its texels that hold some
    dvec3 whole_mean{0};        // of any other: <h>, of length 1 at most
    Tilted still;               // the same along the surface, with the lobe's covariance

    Tilted at(dvec2 lambda) const {
        if (!facets.empty()) return tilted(facets, lambda);
        const dvec2 shift = still.covariance * lambda;
        return {glm::dot(lambda, still.mean) + 0.5 * glm::dot(lambda, shift), still.mean + shift,
                still.covariance};
    }
};

std::vector<Facet> facets_of(const PlacedLobe& placed) {
    std::vector<Facet> facets = placed.lobe->facets(0);
    for (const LobeParameterization& span : placed.lobe->spans())
        for (int i = 0; i < span_side; ++i)
            for (int j = 0; j < span_side; ++j)
                facets.push_back(span_facet(*placed.lobe, span, span_side, i, j));
    std::erase_if(facets, [](const Facet& facet) { return !(facet.mass > 0); });
    for (Facet& facet : facets) facet.h = placed.frame * facet.h;
    return facets;
}

void add_texels(Member& member, const Layer& layer, const PlacedLobe& placed) {
    const Raster& raster = *std::get<PaintedLobe>(layer.lobe).image.raster;
    member.texels = texel_facets(raster, layer.modulation);
    for (std::size_t i = 0; i < member.texels.size(); ++i) {
        Facet& texel = member.texels[i];
        texel.h = placed.frame * texel.h;
        const double mass = texel.mass * static_cast<double>(raster.values[i]);
        if (mass > 0) member.facets.push_back({texel.h, mass});
    }
}

std::vector<Member> members_of(const Distribution& distribution, const FacetDistribution& p) {
    std::vector<Member> members;
    for (const PlacedLobe& placed : p.lobes()) {
        Member member{placed.layer, placed.scale * placed.lobe->mass(), {}, {}, {}, {}};
        if (std::holds_alternative<PaintedLobe>(distribution.layers[placed.layer].lobe)) {
            add_texels(member, distribution.layers[placed.layer], placed);
        } else {
            member.still = tilted(facets_of(placed), dvec2(0));
            member.whole_mean = placed.frame * (placed.lobe->mean() / placed.lobe->mass());
            member.still.mean = along_surface(member.whole_mean);
            if (glm::length(member.whole_mean) < directed) member.still = {};
        }
        members.push_back(std::move(member));
    }
    return members;
}

// ln Z with its derivatives, of all layers.
Tilted tilted(const std::vector<Member>& members, dvec2 lambda) {
    std::vector<Tilted> parts;
    double largest = -HUGE_VAL;
    for (const Member& member : members) {
        parts.push_back(member.at(lambda));
        largest = std::max(largest, parts.back().log_area);
    }
    double sum = 0;
    dvec2 first{0};
    glm::dmat2 second(0.0);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const double area = members[i].weight * std::exp(parts[i].log_area - largest);
        sum += area;
        first += area * parts[i].mean;
        second += area * (parts[i].covariance + square(parts[i].mean));
    }
    const dvec2 mean = first / sum;
    return {largest + std::log(sum), mean, second / sum - square(mean)};
}

[[noreturn]] void refuse(const std::string& why) { throw UserError("", "balance", why); }

// Newton's step; directions in which nothing spreads are left alone.
dvec2 newton_step(const Tilted& now) {
    const glm::dmat2& c = now.covariance;
    const double spread = c[0][0] + c[1][1];
    return -(glm::inverse(c + glm::dmat2(spread * 1e-14)) * now.mean);
}

// Where ln Z is least, by Newton's method with halved steps.
dvec2 minimum(const std::vector<Member>& members) {
    dvec2 lambda{0};
    Tilted now = tilted(members, lambda);
    for (int step = 0; step < steps_max && glm::length(now.mean) > 1e-15; ++step) {
        const dvec2 full = newton_step(now);
        if (!std::isfinite(full.x) || !std::isfinite(full.y)) break;
        const double rounding = 1e-14 * (1 + std::abs(now.log_area));
        bool better = false;
        for (double part = 1; part > 1e-6 && !better; part /= 2) {
            const Tilted next = tilted(members, lambda + part * full);
            better =
                next.log_area < now.log_area - rounding ||
                (next.log_area < now.log_area + rounding && glm::length(next.mean) < glm::length(now.mean));
            if (better) lambda += part * full, now = next;
        }
        if (!better) break;
    }
    if (!(glm::length(now.mean) < 0.1 * balanced_to))
        refuse("all facets are tilted to one side; Straighten turns them instead");
    return lambda;
}

// What floats leave of the mean normal is undone by steps of one float, the largest values first.
void settle(std::vector<float>& values, const std::vector<dvec2>& along) {
    std::vector<std::size_t> order;
    dvec2 excess{0};
    double mass = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] > 0)) continue;
        order.push_back(i);
        excess += static_cast<double>(values[i]) * along[i];
        mass += static_cast<double>(values[i]);
    }
    if (glm::length(excess) < 0.1 * balanced_to * mass) return;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    for (const std::size_t i : order)
        for (const float toward : {0.0f, 1.0f}) {
            const float other = std::nextafter(values[i], toward);
            const dvec2 changed = excess + static_cast<double>(other - values[i]) * along[i];
            if (!(other > 0) || glm::length(changed) >= glm::length(excess)) continue;
            values[i] = other;
            excess = changed;
            break;
        }
}

// The picture times the factor, with its largest value as it was.
void reweight(Layer& layer, const Member& member, dvec2 lambda, dvec2 mean) {
    auto& picture = std::get<PaintedLobe>(layer.lobe).image;
    auto after = std::make_shared<Raster>(*picture.raster);
    std::vector<dvec2> along(after->values.size());  // of each texel from the mean, for a value of 1
    std::vector<double> logs(after->values.size(), -HUGE_VAL);
    double highest_before = 0, highest = -HUGE_VAL;
    for (std::size_t i = 0; i < logs.size(); ++i) {
        const double value = static_cast<double>(after->values[i]);
        const Facet& texel = member.texels[i];
        if (!(value > 0) || !(texel.mass > 0)) continue;
        const dvec2 there = along_surface(texel.h);
        along[i] = texel.mass * (there - mean);
        logs[i] = std::log(value) + glm::dot(lambda, there);
        highest_before = std::max(highest_before, value);
        highest = std::max(highest, logs[i]);
    }
    for (std::size_t i = 0; i < logs.size(); ++i)
        if (member.texels[i].mass > 0)
            after->values[i] = static_cast<float>(highest_before * std::exp(logs[i] - highest));
    settle(after->values, along);
    picture = {{}, std::make_shared<const Raster>(extended_past_rim(*after))};
    layer.source.reset();
}

// The lobe turned so that its mean normal has another part along the surface.
void tilt_to(Layer& layer, const Member& member, dvec2 mean) {
    const double length = glm::length(member.whole_mean);
    if (mean == along_surface(member.whole_mean)) return;
    const double up = length * length - glm::dot(mean, mean);
    if (!(up > 0))
        refuse(
            fmt::format("layer {} would have to tilt past the horizon; Straighten turns all layers instead",
                        member.layer + 1));
    const dvec3 to(mean, std::copysign(std::sqrt(up), member.whole_mean.z));
    layer = carried(layer, member.whole_mean / length, to / length);
}

// Weights that sum to what they did, unless one would be larger than a file holds.
void share_out(Distribution& distribution, const std::vector<std::size_t>& layers,
               const std::vector<double>& shares) {
    double total = 0;
    for (const std::size_t layer : layers) total += distribution.layers[layer].weight;
    total = std::min(total, limits::weight_max / *std::max_element(shares.begin(), shares.end()));
    for (std::size_t i = 0; i < layers.size(); ++i) distribution.layers[layers[i]].weight = total * shares[i];
}

double off_n(const FacetDistribution& p) { return glm::length(along_surface(p.mean())); }

}  // namespace

Distribution balanced(const Distribution& distribution) {
    if (off_n(FacetDistribution(distribution)) < balanced_to) return distribution;
    Distribution result = distribution;
    for (Layer& layer : result.layers)
        if (auto* painted = std::get_if<PaintedLobe>(&layer.lobe); painted && layer.enabled)
            painted->image = {{}, paintable(*painted)};
    const FacetDistribution p(result);
    const std::vector<Member> members = members_of(result, p);
    const dvec2 lambda = minimum(members);
    const Tilted whole = tilted(members, lambda);
    std::vector<std::size_t> layers;
    std::vector<double> shares;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const Member& member = members[i];
        const Tilted part = member.at(lambda);
        const double factor = std::exp(part.log_area - whole.log_area);
        if (factor < least_left)
            refuse(
                fmt::format("next to nothing would be left of layer {}; Straighten turns all layers instead",
                            member.layer + 1));
        layers.push_back(member.layer);
        shares.push_back(member.weight * factor);
        Layer& layer = result.layers[member.layer];
        if (member.facets.empty())
            tilt_to(layer, member, part.mean);
        else
            reweight(layer, member, lambda, part.mean);
    }
    share_out(result, layers, shares);
    if (!(off_n(FacetDistribution(result)) < balanced_to))
        refuse("its pictures are too coarse to hold the mean normal along n");
    return result;
}

}  // namespace nacre
