// p(h) of a whole design: the weighted layers, each in its place, normalised to integral 1.
#pragma once

#include <vector>

#include "core/model/lobe.h"

namespace nacre {

struct PlacedLobe {
    glm::dmat3 frame;  // columns: the lobe's x, y, z in the surface's local frame
    double scale;      // share of facet area over the lobe's own mass
    std::shared_ptr<const LobeModel> lobe;
    std::size_t layer;  // index in the design
};

// The frame of a layer: `rotation` about the axis, then the axis is tilted by `tilt` from n toward `azimuth`.
glm::dmat3 layer_frame(const Layer& layer);

class VisibleFacets;

class FacetDistribution {
  public:
    // Throws UserError when a layer or the whole holds no facets, or when N = <n.h> <= 0.
    // `lobe_of` gives the model of the design's layer of that index.
    using LobeOf = std::function<std::shared_ptr<const LobeModel>(const Layer& layer, std::size_t index)>;
    explicit FacetDistribution(
        const Distribution& distribution,
        const LobeOf& lobe_of = [](const Layer& layer, std::size_t) { return make_lobe(layer); });

    double density(dvec3 h) const;  // per steradian
    // The same of many directions; `p` takes h.size numbers.
    void densities(const DirectionColumns& h, double* p) const;
    Area area(dvec3 k) const;
    double projected_area(dvec3 k) const;           // area(k).g
    dvec3 mean() const { return mean_; }            // H = <h>
    double mean_cosine() const { return mean_.z; }  // N = <n.h>, without mean_cosine_scale

    // A facet as k sees it, density (h.k)+ p(h)/g(k); g(k) > 0.
    dvec3 sample_visible(dvec3 k, Random& random) const;

    // What draws them (visible_facets.h): made by the first call, of whatever thread, for all copies.
    const VisibleFacets& visible_facets() const;

    const std::vector<PlacedLobe>& lobes() const { return lobes_; }

    // Of each lobe that has no smooth form its facets, at most `count` of them or all with 0, in the
    // surface's frame and with their share of area; an empty list for every other lobe.
    std::vector<std::vector<Facet>> facets(std::size_t count) const;

  private:
    struct LazyVisibleFacets;

    std::vector<PlacedLobe> lobes_;
    dvec3 mean_{0};
    std::shared_ptr<LazyVisibleFacets> visible_;
};

}  // namespace nacre
