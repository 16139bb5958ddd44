#include "core/model/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/model/patch_tree.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Children = hn::CappedTag<float, tree_children>;
using Four = hn::CappedTag<float, 4>;

// The same order of operations for any width of vectors, none of them fused: the same bits.
HWY_ATTR inline void look(const PatchBlock& block, const float* k, PatchView& view) {
    const Children d;
    const auto x = hn::Set(d, k[0]), y = hn::Set(d, k[1]), z = hn::Set(d, k[2]);
    const auto zero = hn::Zero(d), half = hn::Set(d, 0.5F);
    for (std::size_t i = 0; i < tree_children; i += hn::Lanes(d)) {
        const auto times = [&](auto a, const float* b) HWY_ATTR { return hn::Mul(a, hn::Load(d, b + i)); };
        const auto m = hn::Add(hn::Add(times(x, block.m[0]), times(y, block.m[1])), times(z, block.m[2]));
        const auto a = hn::Add(hn::Add(times(x, block.l[0]), times(y, block.l[1])), times(z, block.l[2]));
        const auto b = hn::Add(times(y, block.l[3]), times(z, block.l[4]));
        const auto c = times(z, block.l[5]);
        const auto square =
            hn::Add(hn::Add(hn::Mul(m, m), hn::Mul(a, a)), hn::Add(hn::Mul(b, b), hn::Mul(c, c)));
        const auto most = hn::Add(hn::Mul(half, hn::Add(m, hn::Sqrt(square))), hn::Load(d, block.radius + i));
        const auto seen = hn::Mul(most, hn::Load(d, block.mass + i));
        const auto hidden = hn::Lt(hn::Add(m, hn::Load(d, block.reach + i)), zero);
        hn::StoreU(hn::IfThenElse(hidden, zero, seen), d, view.rising + 4 + i);  // 4 are no whole vector
    }
    const Four four;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(four)) {
        auto sum = hn::Zero(four);
        for (float* at = view.rising + i; at < view.rising + tree_children; at += 4) {
            hn::Store(sum, four, at);
            sum = hn::Add(sum, hn::Load(four, at + 4));
        }
        hn::Store(sum, four, view.rising + tree_children + i);
    }
    double all = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        view.before[i] = all;
        all += static_cast<double>(view.rising[tree_children + i]);
    }
    view.all = all;
}

// The child on whose share `left` falls, which is below view.all, and what is left of it there. Without
// branches, which no processor could guess.
HWY_ATTR inline std::size_t choose(const PatchView& view, double& left) {
    const auto reaches = [&left](double sum) { return static_cast<std::size_t>(left >= sum); };
    const std::size_t four = reaches(view.before[1]) + reaches(view.before[2]) + reaches(view.before[3]);
    left -= view.before[four];
    const float* rising = view.rising + four;
    const auto rises = [&](std::size_t i) { return reaches(static_cast<double>(rising[i])); };
    const std::size_t child = 4 * (rises(4) + rises(8) + rises(12));
    left -= static_cast<double>(rising[child]);
    return four + child;
}

void look_at_root(const PatchBlock* blocks, PatchView& view) { look(*blocks, view.k, view); }

// One level after the other, so that the processor looks at many nodes at once.
void walk(const PatchBlock* blocks, std::size_t levels, PatchDescent* descents, std::size_t count) {
    for (PatchDescent* d = descents; d < descents + count; ++d) d->leaf = choose(*d->from, d->left);
    PatchView view;
    for (std::size_t level = 1; level < levels; ++level)
        for (PatchDescent* d = descents; d < descents + count; ++d) {
            if (d->leaf == PatchTree::none) continue;
            look(blocks[d->leaf + 1], d->from->k, view);
            d->leaf =
                d->left < view.all ? tree_children * (d->leaf + 1) + choose(view, d->left) : PatchTree::none;
        }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(look_at_root);
HWY_EXPORT(walk);

// So much of the mass covers the rounding of a node's numbers, and of k, to float.
constexpr double rounding = 1e-6;

// The lower factor of a symmetric matrix without negative eigenvalues, by columns (Cholesky).
std::array<double, 6> factor_of(const glm::dmat3& s) {
    const auto over = [](double a, double b) { return b > 0 ? a / b : 0; };
    const double xx = std::sqrt(std::max(s[0][0], 0.0));
    const double xy = over(s[0][1], xx), xz = over(s[0][2], xx);
    const double yy = std::sqrt(std::max(s[1][1] - xy * xy, 0.0));
    const double yz = over(s[1][2] - xy * xz, yy);
    return {xx, xy, xz, yy, yz, std::sqrt(std::max(s[2][2] - xz * xz - yz * yz, 0.0))};
}

// In halves by count, over and over, across the widest extent of the centres.
void part(const std::vector<PatchBall>& patches, std::span<std::size_t> items, std::size_t parts,
          std::span<std::size_t>* out) {
    if (parts == 1) {
        *out = items;
        return;
    }
    dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    for (const std::size_t i : items) {
        low = glm::min(low, patches[i].centre);
        high = glm::max(high, patches[i].centre);
    }
    const dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = (items.size() + 1) / 2;
    if (half < items.size())
        std::nth_element(
            items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
            [&](std::size_t a, std::size_t b) { return patches[a].centre[axis] < patches[b].centre[axis]; });
    part(patches, items.first(half), parts / 2, out);
    part(patches, items.subspan(half), parts / 2, out + parts / 2);
}

void put(const std::vector<PatchBall>& patches, std::span<const std::size_t> items, PatchBlock& block,
         std::size_t child) {
    double mass = 0, radius = 0, reach = 0;
    dvec3 mean{0};
    for (const std::size_t i : items) {
        mass += patches[i].mass;
        mean += patches[i].mass * patches[i].centre;
        radius += patches[i].mass * patches[i].radius;
    }
    if (!(mass > 0)) {
        block.reach[child] = -1;
        return;
    }
    mean /= mass;
    glm::dmat3 spread(0.0);
    for (const std::size_t i : items) {
        const dvec3 off = patches[i].centre - mean;
        spread += patches[i].mass * glm::outerProduct(off, off);
        reach = std::max(reach, glm::length(off) + patches[i].radius);
    }
    const std::array<double, 6> factor = factor_of(spread / mass);
    for (int i = 0; i < 3; ++i) block.m[i][child] = static_cast<float>(mean[i]);
    for (std::size_t i = 0; i < factor.size(); ++i) block.l[i][child] = static_cast<float>(factor[i]);
    block.reach[child] = static_cast<float>(reach + rounding);
    block.radius[child] = static_cast<float>(radius / mass + rounding);
    block.mass[child] = static_cast<float>(mass);
}

}  // namespace

PatchTree::PatchTree(const std::vector<PatchBall>& patches) {
    std::size_t leaves = tree_children, blocks = 1;
    for (levels_ = 1; leaves < patches.size(); ++levels_) {
        blocks += leaves;
        leaves *= tree_children;
    }
    blocks_.assign(blocks, PatchBlock{});
    order_.assign(leaves, none);
    std::vector<std::size_t> items(patches.size());
    std::iota(items.begin(), items.end(), std::size_t{0});
    fill(patches, items, 1, 0);
}

void PatchTree::fill(const std::vector<PatchBall>& patches, std::span<std::size_t> items, std::size_t level,
                     std::size_t block) {
    std::array<std::span<std::size_t>, tree_children> parts;
    part(patches, items, tree_children, parts.data());
    for (std::size_t i = 0; i < tree_children; ++i) {
        put(patches, parts[i], blocks_[block], i);
        const std::size_t node = tree_children * block + i;
        if (level < levels_)
            fill(patches, parts[i], level + 1, node + 1);
        else if (!parts[i].empty())
            order_[node - first_leaf()] = parts[i].front();
    }
}

// The last level's blocks are the last ones.
std::size_t PatchTree::first_leaf() const { return tree_children * blocks_.size() - order_.size(); }

PatchView PatchTree::view(dvec3 k) const {
    PatchView view;
    for (int i = 0; i < 3; ++i) view.k[i] = static_cast<float>(k[i]);
    HWY_DYNAMIC_DISPATCH(look_at_root)(blocks_.data(), view);
    return view;
}

void PatchTree::descend(std::span<PatchDescent> descents) const {
    HWY_DYNAMIC_DISPATCH(walk)(blocks_.data(), levels_, descents.data(), descents.size());
    for (PatchDescent& descent : descents)
        if (descent.leaf != none) descent.leaf -= first_leaf();
}

}  // namespace nacre
#endif
