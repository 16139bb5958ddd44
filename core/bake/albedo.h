// R(k) = integral of rho(k, k') c' dk' by quadrature in the lobes' own coordinates (Ashikhmin 2000, eq. 29).
#pragma once

#include "core/bake/direction_sums.h"
#include "core/bake/great_circle_quadrature.h"
#include "core/model/facet_distribution.h"

namespace nacre {

// One facet's part of R(k1), its tint left out, whatever gives g(k2); see Shading::facet_albedo.
struct FacetAlbedo {
    template <class AreaOf>
    LayerAlbedo operator()(dvec3 h, const AreaOf& area) const {
        double values[4];
        shading.facet_albedo(Shading<double>::known_direction(k1, g1, dvec3{0}), h, channels, area, values);
        return {values[0], values[1], values[2], values[3]};
    }

    const Shading<double>& shading;
    dvec3 k1;
    double g1;
    int channels;
};

// The bake's rule for R. A smooth lobe: Gauss-Legendre over both halves of psi and over chi, split where
// the integrand is not smooth (GreatCircleQuadrature::cuts), so that the error falls exponentially with the
// order. A lobe of facets: cells of its pyramid, whose error falls with the square of their size. Order and
// count are chosen once for all directions, and once more for those from which p has all but turned away.
class AlbedoQuadrature {
  public:
    // g(k2) is read from the tables that `shading` holds, which holds the lobes' tints too; channels as in
    // Shading::facet_albedo. `tolerance` bounds, absolute, what the rule differs from the next finer one on a
    // few directions down to grazing: half of it in the root mean square, twice at worst; infinity takes the
    // coarsest. Both references are kept.
    AlbedoQuadrature(const FacetDistribution& distribution, const Shading<double>& shading, int channels,
                     double tolerance);

    // The same for a smaller tolerance.
    AlbedoQuadrature finer(double tolerance) const;

    // Refines until at those directions it differs from the finest by no more than `tolerance`, as the few by
    // which a rule is made may miss what a p does within a narrow range. Whether it had to.
    bool refine_at(const std::vector<dvec3>& directions, double tolerance);

    // R(k1), g(k1) given; AlbedoLayout of these channels and the shading's tint says of what.
    AlbedoValues operator()(dvec3 k1, double g1) const;

    // The same of the light that does not leave after one bounce: in place of R, 1 - R where g/G = 1.
    AlbedoValues staying(dvec3 k1, double g1) const;

  private:
    // Of lobes of facets, level by level: each lobe's, none where it is smooth.
    using FacetLevel = std::vector<WeightedDirections>;

    // Of a lobe: where p is seen, and where next to nothing of it is.
    struct Levels {
        std::size_t facing = 0, turned = 0;
    };

    void refine(double tolerance);
    std::size_t choose_level(std::size_t lobe, std::size_t first, const std::vector<dvec3>& trials,
                             double tolerance);
    bool has_turned(double g1) const;
    std::vector<dvec3> turned_directions() const;
    std::size_t level(std::size_t lobe, double g1) const;
    void make_facets(std::size_t level);
    AlbedoValues over_lobes(dvec3 k1, double g1, FirstBounce which) const;
    LayerAlbedo over_lobe(std::size_t lobe, std::size_t level, dvec3 k1, double g1,
                          FirstBounce which = FirstBounce::leaves) const;

    const FacetDistribution& distribution_;
    const Shading<double>& shading_;
    int channels_;
    std::vector<FacetLevel> facets_;
    std::vector<Levels> levels_;  // taken for each lobe
};

}  // namespace nacre
