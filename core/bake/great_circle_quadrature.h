// A smooth lobe's facets on great circles through its axis, in the lobe's own coordinates.
#pragma once

#include <vector>

#include "core/bake/direction_sums.h"
#include "core/model/facet_distribution.h"
#include "core/model/quadrature.h"
#include "core/model/shading.h"

namespace nacre {

// Places on the walk below, in columns: an azimuth psi by its cosine and sine, the angle chi, a weight.
struct WalkPoints {
    std::vector<double> cosine, sine, chi, weight;

    // A rule's points on one great circle, over angles from `begin` on.
    void add(double cosine_of_psi, double sine_of_psi, double begin, double length,
             const std::vector<QuadraturePoint>& rule, double weight_of_all) {
        const std::size_t first = chi.size(), count = first + rule.size();
        cosine.resize(count, cosine_of_psi);
        sine.resize(count, sine_of_psi);
        chi.resize(count);
        weight.resize(count);
        for (std::size_t i = 0; i < rule.size(); ++i) {
            chi[first + i] = begin + length * rule[i].x;
            weight[first + i] = weight_of_all * length * rule[i].weight;
        }
    }
    void clear() {
        for (std::vector<double>* column : {&cosine, &sine, &chi, &weight}) column->clear();
    }
};

// Where a lobe's facets send light from k1 up: on each great circle through the lobe's axis, at azimuth psi
// in the stretched hemisphere, one interval of angles chi from the axis.
class GreatCircleQuadrature {
  public:
    GreatCircleQuadrature(const PlacedLobe& placed, const LobeParameterization& span, dvec3 k1);

    // One great circle.
    struct Ray {
        double cosine, sine;  // of psi
        double begin, end;    // radians; empty when end <= begin
    };
    Ray ray(double psi) const;

    // The facet at chi on a ray and p dh/(dpsi dchi).
    Facet facet(const Ray& ray, double chi) const;

    // The same for many points, each times its weight; those without facets are left out.
    void add_facets(const WalkPoints& points, WeightedDirections& facets) const;

    // psi runs over two halves, [start, start + pi] and the rest, split where the facets turn away from k1.
    double start() const { return start_; }

    // Where R's integrand has a kink or a thin layer, so that rules of integration are used in between; the
    // ends are among them. Azimuths in half turns from start(), then angles on a ray: p's corners; under
    // eq. 14 the plane of k1 and n, where the angle between tangent projections turns round at 180 degrees;
    // with every correlated visibility and a grazing k1 the layer c2 < c1 beside the horizon.
    std::vector<double> azimuth_cuts(MaskingBends bends) const;
    void cuts(const Ray& ray, MaskingBends bends, std::vector<double>& all) const;

  private:
    Ray interval(double cosine, double sine, double least) const;
    dvec3 ray_direction(double cosine, double sine) const {
        return placed_.frame[0] * (span_.stretch.x * cosine) + placed_.frame[1] * (span_.stretch.y * sine);
    }

    const PlacedLobe& placed_;
    LobeParameterization span_;
    dvec3 k1_;
    dvec3 axis_;
    dvec3 across_;  // n x k1
    double start_;
};

}  // namespace nacre
