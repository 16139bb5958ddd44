// A smooth lobe's facets on great circles through its axis, in the lobe's own coordinates.
#pragma once

#include <vector>

#include "core/bake/direction_sums.h"
#include "core/model/facet_distribution.h"

namespace nacre {

// Places on the walk below, in columns: an azimuth psi by its cosine and sine, the angle chi, a weight.
struct WalkPoints {
    std::vector<double> cosine, sine, chi, weight;

    void add(double cosine_of_psi, double sine_of_psi, double angle, double weight_of_it) {
        cosine.push_back(cosine_of_psi);
        sine.push_back(sine_of_psi);
        chi.push_back(angle);
        weight.push_back(weight_of_it);
    }
    void clear() {
        for (std::vector<double>* column : {&cosine, &sine, &chi, &weight}) column->clear();
    }
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

    // The same for many points, each times its weight.
    void add_facets(const WalkPoints& points, WeightedDirections& facets) const;

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

}  // namespace nacre
