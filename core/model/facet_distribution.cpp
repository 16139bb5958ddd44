#include "core/model/facet_distribution.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "core/base/error.h"
#include "core/model/visible_facets.h"

namespace nacre {
namespace {

// A mean cosine under this is rounding: facets that face up and down cancel.
constexpr double smallest_mean_cosine = 1e-7;

glm::dmat3 rotation_about_z(double degrees) {
    // Quarter turns stay exact, so that mirrored layers mirror exactly.
    const double turns = degrees / 90;
    double c = std::cos(degrees * (std::numbers::pi / 180)), s = std::sin(degrees * (std::numbers::pi / 180));
    if (turns == std::round(turns)) {
        c = std::round(c);
        s = std::round(s);
    }
    return {dvec3{c, s, 0}, dvec3{-s, c, 0}, dvec3{0, 0, 1}};
}

}  // namespace

glm::dmat3 layer_frame(const Layer& layer) {
    const double tilt = layer.tilt * (std::numbers::pi / 180);
    const double c = std::cos(tilt), s = std::sin(tilt);
    const glm::dmat3 about_y{dvec3{c, 0, -s}, dvec3{0, 1, 0}, dvec3{s, 0, c}};
    return rotation_about_z(layer.azimuth) * about_y * rotation_about_z(layer.rotation - layer.azimuth);
}

struct FacetDistribution::LazyVisibleFacets {
    std::once_flag made;
    std::unique_ptr<const VisibleFacets> facets;
};

FacetDistribution::FacetDistribution(const Distribution& distribution, const LobeOf& lobe_of)
    : visible_(std::make_shared<LazyVisibleFacets>()) {
    // Shares are taken of the largest weight first, so that weights of 1e-30 and of 1e30 give the same p.
    double largest = 0, total = 0;
    for (const Layer& layer : distribution.layers)
        if (layer.enabled) largest = std::fmax(largest, layer.weight);
    for (const Layer& layer : distribution.layers)
        if (counts(layer)) total += layer.weight / largest;
    for (std::size_t i = 0; i < distribution.layers.size(); ++i) {
        const Layer& layer = distribution.layers[i];
        if (!counts(layer)) continue;
        const std::string where = fmt::format("distribution.layers[{}]", i);
        std::shared_ptr<const LobeModel> lobe = lobe_of(layer, i);
        const double mass = lobe->mass();
        if (!(mass > 0) || !std::isfinite(mass))
            throw UserError("", where, fmt::format("the layer holds no facets (its integral is {:g})", mass));
        lobes_.push_back({layer_frame(layer), layer.weight / largest / total / mass, std::move(lobe), i});
        mean_ += lobes_.back().frame * (lobes_.back().scale * lobes_.back().lobe->mean());
    }
    if (lobes_.empty()) throw UserError("", "distribution.layers", "no enabled layer has a weight above 0");
    if (!(mean_.z > smallest_mean_cosine))
        throw UserError(
            "", "distribution",
            fmt::format("the facets must face up on the whole, N = <n.h> > 0 (found {:.3g})", mean_.z));
}

double FacetDistribution::density(dvec3 h) const {
    double sum = 0;
    for (const PlacedLobe& placed : lobes_)
        sum += placed.scale * placed.lobe->density(glm::transpose(placed.frame) * h);
    return sum;
}

void FacetDistribution::densities(const DirectionColumns& h, double* p) const {
    std::vector<double> columns(4 * h.size);
    double *x = columns.data(), *y = x + h.size, *z = y + h.size, *part = z + h.size;
    std::fill_n(p, h.size, 0.0);
    for (const PlacedLobe& placed : lobes_) {
        for (std::size_t i = 0; i < h.size; ++i) {
            const dvec3 own = glm::transpose(placed.frame) * dvec3(h.x[i], h.y[i], h.z[i]);
            x[i] = own.x, y[i] = own.y, z[i] = own.z;
        }
        placed.lobe->densities({x, y, z, h.size}, part);
        for (std::size_t i = 0; i < h.size; ++i) p[i] += placed.scale * part[i];
    }
}

Area FacetDistribution::area(dvec3 k) const {
    Area sum;
    for (const PlacedLobe& placed : lobes_) {
        const Area part = placed.lobe->area(glm::transpose(placed.frame) * k);
        sum.g += placed.scale * part.g;
        sum.gradient += placed.scale * (placed.frame * part.gradient);
    }
    return sum;
}

double FacetDistribution::projected_area(dvec3 k) const {
    double sum = 0;
    for (const PlacedLobe& placed : lobes_)
        sum += placed.scale * placed.lobe->projected_area(glm::transpose(placed.frame) * k);
    return sum;
}

std::vector<std::vector<Facet>> FacetDistribution::facets(std::size_t count) const {
    std::vector<std::vector<Facet>> all;
    for (const PlacedLobe& placed : lobes_) {
        all.push_back(placed.lobe->facets(count));
        for (Facet& facet : all.back()) facet = {placed.frame * facet.h, placed.scale * facet.mass};
    }
    return all;
}

dvec3 FacetDistribution::sample_visible(dvec3 k, Random& random) const {
    return *visible_facets()(k, random);
}

const VisibleFacets& FacetDistribution::visible_facets() const {
    std::call_once(visible_->made, [&] { visible_->facets = std::make_unique<const VisibleFacets>(lobes_); });
    return *visible_->facets;
}

}  // namespace nacre
