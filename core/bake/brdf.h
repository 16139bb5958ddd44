// The BRDF of a baked design, as a renderer would call it: evaluate, sample and pdf together.
#pragma once

#include <optional>

#include "core/bake/tables.h"
#include "core/shading/term.h"

namespace nacre {

struct BrdfSample {
    dvec3 k2;      // unit, above the horizon
    dvec3 weight;  // rho(k1, k2) (k2.n)/pdf, each colour; at most F(k.h) for a mirrored sample of a valid p
    double pdf;    // of k2, 1/sr
};

// All directions are unit vectors in the local frame (z = n) that point away from the surface. Values are in
// 1/sr and symmetric in k1 and k2 to the last bit.
class Brdf {
  public:
    explicit Brdf(std::shared_ptr<const Tables> tables) : tables_(std::move(tables)) {}

    // 0 where either direction is not above the horizon.
    dvec3 evaluate(dvec3 k1, dvec3 k2, Term term = Term::total) const;

    // Visible normals, p(h)/(4 g(k1)) of k2 (Heitz & d'Eon 2014, for any p), turned half about n before or
    // after as often as the design is retro-reflective, and mixed with a cosine about n: half and half where
    // it has a diffuse term, three to one where light bounces between the facets or beneath a coat. Under a
    // coat they are those beneath it, and mixed with the coat's own as much as that mirrors. Nothing is
    // returned for a sample below the horizon, which a renderer counts as black. The first call for a p takes
    // some milliseconds: see FacetDistribution::visible_facets().
    std::optional<BrdfSample> sample(dvec3 k1, Random& random) const;

    // k2 of a sample alone; k2.z <= 0 where there is none.
    dvec3 draw(dvec3 k1, Random& random) const;
    double pdf(dvec3 k1, dvec3 k2) const;

    // How often sample() draws the cosine.
    double cosine_probability() const;

    // R(k), the directional albedo of the specular term (Ashikhmin 2000, eq. 29) of intensity 1, under a coat
    // that beneath it; 0 when R is not baked.
    dvec3 albedo(dvec3 k) const;

    // The same of the whole BRDF: how much of the light from k comes back; 0 when R is not baked.
    dvec3 total_albedo(dvec3 k) const;

    const Tables& tables() const { return *tables_; }

  private:
    friend class BrdfSampler;

    dvec3 draw_facet(dvec3 k1, Random& random) const;
    dvec3 draw_coated(const Shading<double>::Direction& from, Random& random) const;

    std::shared_ptr<const Tables> tables_;
};

// Brdf::sample() from one k1 again and again: its tables are read once.
class BrdfSampler {
  public:
    // `brdf` is kept as a reference.
    BrdfSampler(const Brdf& brdf, dvec3 k1);
    std::optional<BrdfSample> operator()(Random& random) const;

  private:
    const Brdf& brdf_;
    dvec3 k1_;
    Shading<double>::Direction from_;
};

// k mirrored by a facet; of length 1, to rounding, as both are.
inline dvec3 mirrored(dvec3 k, dvec3 h) { return 2 * glm::dot(k, h) * h - k; }

// One term of the BRDF (term.h says in which unit) from what is known of both directions; `shading` holds the
// design.
dvec3 brdf_term(const Shading<double>& shading, const Shading<double>::Direction& a,
                const Shading<double>::Direction& b, Term term);

}  // namespace nacre
