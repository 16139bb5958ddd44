#include "core/model/lobe_envelope.h"

#include <optional>
#include <queue>
#include <utility>

namespace nacre {
namespace {

// A patch that waits to be split, and what that would gain.
struct OpenPatch {
    FacetPatch patch;
    std::vector<FacetPatch> parts;
    double gain;

    bool operator<(const OpenPatch& other) const { return gain < other.gain; }
};

}  // namespace

// As many facets are drawn of a patch as k may see of it, (c.k)+ + radius times its mass; (c.k)+ is typically
// the envelope's scale where few facets are seen.
std::vector<FacetPatch> split_envelope(const LobeEnvelope& envelope, std::size_t count) {
    const double scale = envelope.scale();
    const auto drawn = [&](const std::vector<FacetPatch>& patches) {
        double sum = 0;
        for (const FacetPatch& patch : patches) sum += patch.mass * (scale + patch.radius);
        return sum;
    };
    std::priority_queue<OpenPatch> open;
    std::vector<FacetPatch> patches;
    const auto wait = [&](const FacetPatch& patch) {
        std::optional<OpenPatch> best;
        const double whole = drawn({patch});
        for (LobeEnvelope::Parts& parts : envelope.splits(patch)) {
            const double gain = whole - drawn(parts);
            if (!best || gain > best->gain) best = {patch, std::move(parts), gain};
        }
        if (best)
            open.push(std::move(*best));
        else
            patches.push_back(patch);
    };
    for (const FacetPatch& patch : envelope.whole()) wait(patch);
    while (!open.empty() && patches.size() + open.size() - 1 + open.top().parts.size() <= count) {
        const OpenPatch top = open.top();
        open.pop();
        for (const FacetPatch& part : top.parts) wait(part);
    }
    for (; !open.empty(); open.pop()) patches.push_back(open.top().patch);
    return patches;
}

}  // namespace nacre
