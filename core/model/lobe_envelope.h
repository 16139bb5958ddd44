// Densities that lie above a lobe's p and are easily drawn from, in patches of the sphere: what visible
// facets are drawn from by rejection.
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/lobe_model.h"

namespace nacre {

// A part of a span (see LobeParameterization): h' of heights t0 to t1 above the lobe's horizon, between the
// azimuths e0 and e1, unit vectors less than half a turn apart, e1 on the left.
struct SpanCell {
    double t0 = 0, t1 = 0;
    dvec2 e0{0}, e1{0};
};

// Texels begin to end - 1 of a picture in Morton order; their number is a power of four.
struct TexelRange {
    std::size_t begin = 0, end = 0;
};

// A patch of facets in the lobe's own frame; what drawing from it reads comes first.
struct FacetPatch {
    std::size_t span = 0;
    SpanCell cell = {};
    double peak = 0;  // what the lobe's density is at most, in the coordinates of `span`
    TexelRange texels = {};
    double factor = 1;  // the most that a picture by which the lobe is multiplied is there

    dvec3 centre{0};         // unit
    double radius = 0;       // no facet of the patch is farther away from there
    double mass = 0;         // of the envelope
    dvec2 low{-1}, high{1};  // a rectangle on the equal-area disk, which holds those that face up
};

class LobeEnvelope {
  public:
    virtual ~LobeEnvelope() = default;

    // Patches that hold all facets, those without mass left out.
    virtual std::vector<FacetPatch> whole() const = 0;

    // The parts of a patch, those without mass left out, in each way in which it may be split; no way where
    // it is not to be.
    using Parts = std::vector<FacetPatch>;
    virtual std::vector<Parts> splits(const FacetPatch& patch) const = 0;

    // So far from k's horizon as facets typically are where k is at right angles to the lobe's axis.
    virtual double scale() const = 0;

    // A facet of a patch, drawn from the envelope, and what part of it p is there: 0 to 1.
    struct Draw {
        dvec3 h;
        double part;
    };
    virtual Draw draw(const FacetPatch& patch, Random& random) const = 0;

  protected:
    LobeEnvelope() = default;
    LobeEnvelope(const LobeEnvelope&) = delete;
    LobeEnvelope& operator=(const LobeEnvelope&) = delete;
};

// At most `count` patches, or as many as whole() has: that patch is split first by which the number of facets
// that are drawn in vain falls most.
std::vector<FacetPatch> split_envelope(const LobeEnvelope& envelope, std::size_t count);

}  // namespace nacre
