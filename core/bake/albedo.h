// R(k) = integral of rho(k, k') c' dk' by quadrature in the lobes' own coordinates (Ashikhmin 2000, eq. 29).
#pragma once

#include "core/model/facet_distribution.h"
#include "core/model/quadrature.h"
#include "core/model/shading.h"

namespace nacre {

// R with F = 1, then with one or three Fresnel factors (Schlick's weight, or the design's exact F).
using AlbedoValues = Values<4>;

// The integrand over facets: with dk2 = 4 (k1.h) dh, a facet of mass p dh adds F (k1.h) V(k1, k2) c2 of it,
// V = P12/(N c1 c2).
class FacetAlbedo {
  public:
    // `area` gives g(k2); channels = 0, 1 or 3 Fresnel factors.
    template <class AreaOf>
    AlbedoValues operator()(dvec3 h, const AreaOf& area) const {
        AlbedoValues values{};
        const double kh = glm::dot(k1, h);
        if (kh <= 0) return values;
        const dvec3 k2 = 2 * kh * h - k1;
        if (k2.z <= 0) return values;
        const double full = kh * k2.z * shading.visibility({k1, g1, dvec3{0}}, {k2, area(k2), dvec3{0}});
        values[0] = full;
        const double cosine = kh < 1 ? kh : 1;
        if (channels == 1) values[1] = full * Shading<double>::schlick_weight(cosine);
        if (channels == 3) {
            const dvec3 f = shading.fresnel(cosine);
            for (int i = 0; i < 3; ++i) values[static_cast<std::size_t>(i + 1)] = full * f[i];
        }
        return values;
    }

    const Shading<double>& shading;
    dvec3 k1;
    double g1;
    int channels;
};

// Where a lobe's facets send light from k1 up: on each great circle through the lobe's axis, at azimuth psi
// in the stretched hemisphere, one interval of angles chi from the axis.
class LobeWalk {
  public:
    LobeWalk(const PlacedLobe& placed, const LobeSpan& span, dvec3 k1);

    // One great circle.
    struct Ray {
        double cosine, sine;  // of psi
        double begin, end;    // radians; empty when end <= begin
    };
    Ray ray(double psi) const;

    // The facet at chi on a ray and p dh/(dpsi dchi).
    Facet facet(const Ray& ray, double chi) const;

    // psi runs over two halves, [start, start + pi] and on, parted where the facets turn from k1.
    double start() const { return start_; }

    const std::vector<double>& breaks() const { return span_.breaks; }

  private:
    const PlacedLobe& placed_;
    LobeSpan span_;
    dvec3 k1_;
    dvec3 axis_;
    double start_;
};

// The bake's rule for R. A smooth lobe: Gauss-Legendre over both halves of psi and over chi; the integrand is
// smooth on each, so that the error falls exponentially with the order. A lobe of facets: cells of its
// pyramid, whose error falls with the square of their size. Order and count are chosen once, for all
// directions.
class AlbedoRule {
  public:
    // g(k2) is read from the tables that `shading` holds; channels as in FacetAlbedo. `tolerance` bounds,
    // absolute, what the rule differs from the next finer one on a few directions down to grazing: half of it
    // in the root mean square, twice at worst; infinity takes the coarsest. Both references are kept.
    AlbedoRule(const FacetDistribution& distribution, const Shading<double>& shading, int channels,
               double tolerance);

    // R(k1), g(k1) given.
    AlbedoValues operator()(dvec3 k1, double g1) const;

  private:
    std::size_t levels(std::size_t lobe) const;
    std::size_t choose_level(std::size_t lobe, double tolerance) const;
    AlbedoValues over_lobe(std::size_t lobe, std::size_t level, dvec3 k1, double g1) const;
    AlbedoValues over_span(const LobeWalk& walk, std::size_t level, const FacetAlbedo& albedo) const;

    const FacetDistribution& distribution_;
    const Shading<double>& shading_;
    int channels_;
    std::vector<std::vector<std::vector<Facet>>> facets_;  // [lobe][level], in the surface's frame
    std::vector<std::size_t> level_;                       // taken for each lobe
};

}  // namespace nacre
