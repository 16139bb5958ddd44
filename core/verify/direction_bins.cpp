#include "core/verify/direction_bins.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

constexpr std::ptrdiff_t least_shares = 32;  // of a bin

double total(const DirectionShare* begin, const DirectionShare* end) {
    double sum = 0;
    for (const DirectionShare* i = begin; i < end; ++i) sum += i->share;
    return sum;
}

int wider_axis(const DirectionShare* begin, const DirectionShare* end) {
    dvec3 low = begin->k, high = begin->k;
    for (const DirectionShare* i = begin; i < end; ++i) {
        low = glm::min(low, i->k);
        high = glm::max(high, i->k);
    }
    return high.x - low.x >= high.y - low.y ? 0 : 1;
}

// Where the shares, sorted along `axis`, are halved between two that differ; `end` where they cannot be.
DirectionShare* middle_of(DirectionShare* begin, DirectionShare* end, int axis) {
    double left = 0.5 * total(begin, end);
    DirectionShare* middle = begin;
    while (middle < end && left > 0) left -= (middle++)->share;
    while (middle > begin && middle < end && middle->k[axis] == (middle - 1)->k[axis]) ++middle;
    return std::min(middle - begin, end - middle) < least_shares ? end : middle;
}

}  // namespace

DirectionBins::DirectionBins(std::vector<DirectionShare> shares, int most) {
    part(shares.data(), shares.data() + shares.size(), most);
}

int DirectionBins::part(DirectionShare* begin, DirectionShare* end, int most) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    if (most > 1 && end - begin >= 2 * least_shares) {
        const int axis = wider_axis(begin, end);
        std::sort(begin, end,
                  [axis](const DirectionShare& a, const DirectionShare& b) { return a.k[axis] < b.k[axis]; });
        DirectionShare* middle = middle_of(begin, end, axis);
        if (middle < end) {
            Node node{.axis = axis, .at = 0.5 * ((middle - 1)->k[axis] + middle->k[axis])};
            node.below = part(begin, middle, most / 2);
            node.above = part(middle, end, most - most / 2);
            nodes_[static_cast<std::size_t>(index)] = node;
            return index;
        }
    }
    nodes_[static_cast<std::size_t>(index)].bin = share_.size();
    share_.push_back(total(begin, end));
    variance_.push_back(0);
    for (const DirectionShare* i = begin; i < end; ++i) variance_.back() += i->share * i->share;
    return index;
}

std::size_t DirectionBins::index(dvec3 k) const {
    const Node* node = nodes_.data();
    while (node->below >= 0)
        node = &nodes_[static_cast<std::size_t>(k[node->axis] < node->at ? node->below : node->above)];
    return node->bin;
}

}  // namespace nacre
