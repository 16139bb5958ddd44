#include "core/model/visible_facets.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/model/visible_sampler.h"

namespace nacre {
namespace {

constexpr std::size_t patches_max = 4096;  // of all lobes together
constexpr double mass_min = 1e-30;         // of a patch, so that it is a float whatever k sees of it
constexpr int trials_max = 100;
constexpr std::size_t at_once = 64;

}  // namespace

VisibleFacets::VisibleFacets(std::vector<PlacedLobe> lobes) : lobes_(std::move(lobes)), tree_(add_patches()) {
    std::vector<Leaf> leaves(tree_.order().size());
    for (std::size_t i = 0; i < leaves.size(); ++i)
        if (tree_.order()[i] != PatchTree::none) leaves[i] = leaves_[tree_.order()[i]];
    leaves_ = std::move(leaves);
}

std::vector<PatchBall> VisibleFacets::add_patches() {
    for (const PlacedLobe& placed : lobes_) {
        envelopes_.push_back(placed.lobe->closed_form() ? nullptr : placed.lobe->envelope());
        if (!envelopes_.back()) own_.push_back(&placed);
    }
    std::vector<PatchBall> balls;
    for (std::size_t lobe = 0; lobe < lobes_.size(); ++lobe) {
        if (!envelopes_[lobe]) continue;
        const PlacedLobe& placed = lobes_[lobe];
        for (const FacetPatch& patch :
             split_envelope(*envelopes_[lobe], patches_max / (lobes_.size() - own_.size()))) {
            const double mass = placed.scale * patch.mass;
            if (mass < mass_min) continue;
            leaves_.push_back({mass, lobe, patch});
            balls.push_back({placed.frame * patch.centre, patch.radius, mass});
        }
    }
    return balls;
}

double VisibleFacets::own_area(std::size_t own, dvec3 k) const {
    const PlacedLobe& placed = *own_[own];
    return placed.scale * placed.lobe->projected_area(glm::transpose(placed.frame) * k);
}

double VisibleFacets::own_area(dvec3 k) const {
    double sum = 0;
    for (std::size_t i = 0; i < own_.size(); ++i) sum += own_area(i, k);
    return sum;
}

double VisibleFacets::bound(dvec3 k) const { return tree_.view(k).all + own_area(k); }

// Of the lobes that draw by themselves the one on whose area `left` falls.
dvec3 VisibleFacets::draw_own(double left, dvec3 k, Random& random) const {
    std::size_t chosen = 0;
    for (std::size_t i = 0; own_.size() > 1 && i < own_.size(); ++i) {
        const double area = own_area(i, k);
        if (area > 0) chosen = i;
        if (left < area) break;
        left -= area;
    }
    const PlacedLobe& placed = *own_[chosen];
    return placed.frame * placed.lobe->sample_visible(glm::transpose(placed.frame) * k, random);
}

// `left` is even within the leaf's share of the bound, so that it also decides whether the facet is kept.
bool VisibleFacets::draw_patch(const PatchDescent& descent, dvec3 k, Random& random, dvec3& h) const {
    if (descent.leaf == PatchTree::none) return false;
    const Leaf& leaf = leaves_[descent.leaf];
    const LobeEnvelope::Draw drawn = envelopes_[leaf.lobe]->draw(leaf.patch, random);
    const dvec3 facet = lobes_[leaf.lobe].frame * drawn.h;
    if (!(descent.left < leaf.mass * drawn.part * glm::dot(facet, k))) return false;
    h = facet;
    return true;
}

// Finds g, which takes longer.
dvec3 VisibleFacets::draw_exactly(dvec3 k, Random& random) const {
    const VisibleSampler exact(lobes_, k);
    return exact.area() > 0 ? exact(random) : dvec3{0};
}

// After that many trials in vain as good as nothing is seen, of facets that turn away.
template <std::size_t Most>
void VisibleFacets::draw_some(std::span<const dvec3> k, Random& random, std::span<dvec3> h) const {
    std::array<PatchView, Most> views;
    std::array<double, Most> bounds;
    std::array<std::size_t, Most> waiting;
    std::array<PatchDescent, Most> descents;
    std::size_t waits = 0;
    for (std::size_t i = 0; i < k.size(); ++i) {
        views[i] = tree_.view(k[i]);
        bounds[i] = views[i].all + own_area(k[i]);
        if (bounds[i] > 0)
            waiting[waits++] = i;
        else
            h[i] = draw_exactly(k[i], random);
    }
    for (int trial = 0; waits > 0 && trial < trials_max; ++trial) {
        std::size_t down = 0;
        for (std::size_t j = 0; j < waits; ++j) {
            const std::size_t i = waiting[j];
            const double left = uniform_random(random) * bounds[i];
            if (left < views[i].all)
                descents[down++] = {&views[i], left, 0};
            else
                h[i] = draw_own(left - views[i].all, k[i], random);
        }
        tree_.descend({descents.data(), down});
        waits = 0;
        for (std::size_t j = 0; j < down; ++j) {
            const auto i = static_cast<std::size_t>(descents[j].from - views.data());
            if (!draw_patch(descents[j], k[i], random, h[i])) waiting[waits++] = i;
        }
    }
    for (std::size_t j = 0; j < waits; ++j) h[waiting[j]] = draw_exactly(k[waiting[j]], random);
}

void VisibleFacets::draw(std::span<const dvec3> k, Random& random, std::span<dvec3> h) const {
    for (std::size_t i = 0; i < k.size(); i += at_once) {
        const std::size_t count = std::min(at_once, k.size() - i);
        draw_some<at_once>(k.subspan(i, count), random, h.subspan(i, count));
    }
}

std::optional<dvec3> VisibleFacets::operator()(dvec3 k, Random& random) const {
    dvec3 h;
    draw_some<1>({&k, 1}, random, {&h, 1});
    if (h == dvec3{0}) return {};
    return h;
}

}  // namespace nacre
