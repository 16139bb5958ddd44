#include "core/bake/coat_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bounce_directions.h"
#include "core/bake/mirror_ways.h"
#include "core/model/facet_lattice.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;

constexpr int rounds_max = 400;
constexpr double settled = 1e-7;

double critical_cosine(double ior) { return std::sqrt(1 - 1 / (ior * ior)); }

// The inverse of inside_direction().
double inside_place(dvec3 k, double ior) {
    const double outside2 = 1 - ior * ior * (k.x * k.x + k.y * k.y);
    if (outside2 >= 0) return std::sqrt(std::sqrt(outside2));
    return std::max(k.z / critical_cosine(ior) - 1, -1.0);
}

}  // namespace

dvec3 inside_direction(double at, dvec2 azimuth, double ior) {
    double sine = 1;
    if (at >= 0) {
        sine = std::sqrt(std::max(1 - std::pow(at, 4), 0.0)) / ior;
    } else {
        const double cosine = critical_cosine(ior) * (1 + at);
        sine = std::sqrt(1 - cosine * cosine);
    }
    return {azimuth * sine, std::sqrt(std::max(1 - sine * sine, 0.0))};
}

CoatLightIntegral::CoatLightIntegral(const FacetDistribution& p, const Shader& shading, std::size_t facets,
                                     int cosines)
    : shading_(shading), facets_(facet_lattice(p, facets)) {
    if (!shading.kinds.bounces() && shading.kinds.diffuse == kind_index<Diffuse, NoDiffuse>()) return;
    for (const dvec3 k : even_directions(cosines)) ends_.push_back(shading_.direction(k));
}

CoatLightIntegral::Direction CoatLightIntegral::beneath(dvec3 k) const {
    return Shader::known_direction(k, shading_.projected_area(k, shading_.table_spot(k)), dvec3{0});
}

// A facet of mass p dh adds 4 (k.h) rho c2/p of it. Where tints differ p itself is asked, as rho is.
template <class Visit>
void CoatLightIntegral::scatter(dvec3 k, const Visit& visit) const {
    const Direction from = ends_.empty() && !shading_.kinds.retro ? beneath(k) : shading_.direction(k);
    for (const Direction& to : ends_) {
        dvec3 rho = shading_.diffuse(from, to);
        if (shading_.kinds.bounces()) rho += shading_.whole_multibounce(from, to) * shading_.surface.ks;
        visit(to.k, rho * (pi / static_cast<double>(ends_.size())));
    }
    for (const MirrorWay& way : mirror_ways(shading_)) {
        if (!(way.part > 0)) continue;
        const Direction a = way.before ? Shader::turned(from) : from;
        for (const Facet& facet : facets_) {
            const double kh = glm::dot(a.k, facet.h);
            const dvec3 k2 = 2 * kh * facet.h - a.k;
            if (kh <= 0 || k2.z <= 0) continue;
            const double p = shading_.kinds.tint == Tint::varied ? shading_.density(facet.h) : 1;
            if (!(p > 0)) continue;
            const dvec3 rho =
                shading_.specular_of(a, beneath(k2), {facet.h, std::fmin(kh, 1.0), true}, p) / p;
            visit(way.leaving(k2), rho * (way.part * shading_.surface.ks * 4 * kh * facet.mass * k2.z));
        }
    }
}

dvec3 CoatLightIntegral::through(dvec3 k) const {
    const double at = inside_place(k, shading_.surface.coat_ior);
    return at <= 0 ? dvec3{0} : shading_.coat_way(k.z) * (1 - shading_.coat_albedo(at));
}

dvec3 CoatLightIntegral::returned(dvec3 k) const {
    const double at = inside_place(k, shading_.surface.coat_ior);
    const dvec3 way = shading_.coat_way(std::fmax(k.z, 1e-9));
    return way * way * (at <= 0 ? 1 : shading_.coat_albedo(at));
}

CoatLightIntegral::Spot CoatLightIntegral::spot(dvec3 k) const {
    const double place = 0.5 * (1 + inside_place(k, shading_.surface.coat_ior)) * (nodes_ - 1);
    const int left = std::min(static_cast<int>(place), nodes_ - 2);
    const auto at = shading_.table_spot(k);
    const auto rows =
        shading_.table_rows(0.5 * (at.turns + Shader::quarter_turns(at.azimuth.x, at.azimuth.y)), rows_);
    const double s = place - left, t = rows.fraction;
    const auto node = [&](int row, int column) { return static_cast<std::size_t>(row * nodes_ + column); };
    return {{node(rows.first, left), node(rows.first, left + 1), node(rows.second, left),
             node(rows.second, left + 1)},
            {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
}

dvec3 CoatLightIntegral::read(const Spot& spot) const {
    dvec3 sum{0};
    for (int i = 0; i < 4; ++i) sum += spot.weight[i] * whole_[spot.node[i]];
    return sum;
}

// Of u = integral of rho (t + f u) c2 dk2: each node's row of that is summed once, then u follows by Gauss
// and Seidel's rounds. What lies beneath and sends back more than it gets counts as if it sent back all.
void CoatLightIntegral::solve(int nodes, const std::vector<dvec2>& azimuths, Workers& workers) {
    nodes_ = nodes;
    rows_ = static_cast<int>(azimuths.size());
    const std::size_t count = static_cast<std::size_t>(nodes_ * rows_);
    std::vector<dvec3> once(count, dvec3{0});
    std::vector<std::vector<dvec3>> rows(count, std::vector<dvec3>(count, dvec3{0}));
    workers.for_each(static_cast<int>(count), [&](int i) {
        const std::size_t own = static_cast<std::size_t>(i);
        const double at = 2.0 * (i % nodes_) / (nodes_ - 1) - 1;
        dvec3 all{0};
        scatter(
            inside_direction(at, azimuths[own / static_cast<std::size_t>(nodes_)], shading_.surface.coat_ior),
            [&](dvec3 k2, dvec3 part) {
                all += part;
                once[own] += part * through(k2);
                const Spot to = spot(Shader::turned(k2));
                const dvec3 back = part * returned(k2);
                for (int j = 0; j < 4; ++j) rows[own][to.node[j]] += to.weight[j] * back;
            });
        const dvec3 most = glm::max(all, 1.0);
        once[own] = once[own] / most;
        for (dvec3& entry : rows[own]) entry = entry / most;
    });
    whole_ = once;
    for (int round = 0; round < rounds_max; ++round) {
        workers.check();
        double change = 0;
        for (std::size_t i = 0; i < count; ++i) {
            dvec3 sum = once[i];
            for (std::size_t j = 0; j < count; ++j) sum += rows[i][j] * whole_[j];
            const dvec3 step = glm::abs(sum - whole_[i]);
            change = std::max({change, step.x, step.y, step.z});
            whole_[i] = sum;
        }
        if (change < settled) break;
    }
}

CoatLight CoatLightIntegral::operator()(dvec3 k) const {
    CoatLight light;
    dvec3 all{0};
    scatter(k, [&](dvec3 k2, dvec3 part) {
        all += part;
        light.once += part * through(k2);
        light.again += part * returned(k2) * read(spot(Shader::turned(k2)));
    });
    const dvec3 most = glm::max(all, 1.0);
    return {light.once, light.again / most};
}

}  // namespace nacre
