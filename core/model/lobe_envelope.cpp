#include "core/model/lobe_envelope.h"

#include <algorithm>
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
    const auto drawn = [&](const FacetPatch& patch) { return patch.mass * (scale + patch.radius); };
    std::priority_queue<OpenPatch> open;
    std::vector<FacetPatch> patches;
    const auto wait = [&](const FacetPatch& patch) {
        std::optional<std::vector<FacetPatch>> parts = envelope.split(patch);
        if (!parts) {
            patches.push_back(patch);
            return;
        }
        double gain = drawn(patch);
        for (const FacetPatch& part : *parts) gain -= drawn(part);
        open.push({patch, std::move(*parts), gain});
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
