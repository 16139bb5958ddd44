// One normal distribution in its lobe's own frame (z = the lobe's axis), as the bake, the reference and the
// sampler need it. Densities are those of shaders/shared/lobes.glsl: not normalised.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <random>
#include <vector>

namespace nacre {

using glm::dvec2;
using glm::dvec3;

using Random = std::mt19937_64;

// g(k) = integral over h.k > 0 of (h.k) p(h) dh, defined for every k of the sphere (Ashikhmin 2000, eq. 18),
// and its gradient, the integral over the same facets of h p(h). g is homogeneous: g = k . gradient; both
// are kept because the product loses all digits where g is tiny.
struct Area {
    double g = 0;
    dvec3 gradient{0};
};

// A facet direction that represents a small patch of facets; mass = p times the patch's solid angle.
struct Facet {
    dvec3 h;
    double mass;
};

// Unit vectors in columns; owned by others.
struct DirectionColumns {
    const double *x, *y, *z;
    std::size_t size;
};

// A parameterisation of a lobe for integration, in its own coordinates. The upper hemisphere h' (uniform
// measure) is mapped by h = A h'/|A h'|, A = diag(stretch.x, stretch.y, 1), which makes any width one. Great
// circles through the axis stay great circles, so that "k2 above the horizon" is one interval on each of
// them.
struct LobeParameterization {
    dvec2 stretch{1};
    double flip = 1;             // -1: the hemisphere below the lobe's own horizon
    std::vector<double> breaks;  // angles from the axis (radians, in h') where p has a corner, rising
};

class LobeEnvelope;

class LobeModel {
  public:
    virtual ~LobeModel() = default;

    // p(h), not normalised. |h| = 1.
    virtual double density(dvec3 h) const = 0;

    // density() of many directions, to a few units in the last place; `p` takes h.size numbers.
    virtual void densities(const DirectionColumns& h, double* p) const;

    // Integral of p over the sphere, steradians times the unit of p. Positive and finite.
    virtual double mass() const = 0;

    virtual Area area(dvec3 k) const = 0;

    // g alone.
    virtual double projected_area(dvec3 k) const { return area(k).g; }

    // Mean direction <h> (not divided by the mass), from g(k) - g(-k) = k . <h>.
    virtual dvec3 mean() const;

    // The hemispheres that hold the lobe; empty for a lobe that is a set of facets.
    virtual std::vector<LobeParameterization> spans() const = 0;

    // The same of every lobe: in these coordinates a picture alone is narrow.
    virtual std::vector<LobeParameterization> domains() const { return spans(); }

    // The facets of a lobe that has no smooth form: about `count` at most, or all with 0.
    virtual std::vector<Facet> facets(std::size_t count) const;

    // The same so fine that any smooth function may be read at each, of mass p times a weight: one after
    // another.
    virtual void visit_points(const std::function<void(const Facet&)>& visit) const;

    // A facet as k sees it: density (h.k)+ p(h)/g(k). g(k) must be positive. Exact for every k, but slow
    // where g is no closed form; VisibleFacets draws faster from envelope().
    virtual dvec3 sample_visible(dvec3 k, Random& random) const = 0;

    // Whether projected_area() and sample_visible() cost no more than a draw from an envelope does.
    virtual bool closed_form() const { return false; }

    // A density above p that is easily drawn from, see lobe_envelope.h; null where none is known. The lobe
    // has to outlive it.
    virtual std::unique_ptr<const LobeEnvelope> envelope() const;

  protected:
    LobeModel() = default;
    LobeModel(const LobeModel&) = delete;
    LobeModel& operator=(const LobeModel&) = delete;
};

// How finely a lobe that holds a picture is split into facets; any other lobe is exact.
enum class Fineness {
    bake,  // for tables: g to 3e-6 of the whole, 1e-4 of a modulated lobe whose texels are noise
    exact  // for the reference: 1e-6 and 1e-5
};

double uniform_random(Random& random);  // in [0, 1)

// A direction about z, and the density that it is drawn with: cos(theta)/pi, 1/sr; k.z >= 0.
dvec3 cosine_sample(Random& random);
double cosine_density(dvec3 k);

}  // namespace nacre
