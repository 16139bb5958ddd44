// Sums over lists of directions, many side by side in vectors as wide as the processor has. The same for any
// number of threads; the order of a sum follows the width of the vectors.
#pragma once

#include <vector>

#include "core/bake/albedo_values.h"
#include "core/model/lobe.h"
#include "core/model/shading.h"

namespace nacre {

// Unit vectors in columns, each with its weight.
class WeightedDirections {
  public:
    void add(dvec3 direction, double weight) {
        x_.push_back(direction.x);
        y_.push_back(direction.y);
        z_.push_back(direction.z);
        weight_.push_back(weight);
    }
    void clear() { resize(0); }

    // What is new is to be written to the columns.
    void resize(std::size_t size) {
        for (std::vector<double>* column : {&x_, &y_, &z_, &weight_}) column->resize(size);
    }

    std::size_t size() const { return x_.size(); }
    const double* x() const { return x_.data(); }
    const double* y() const { return y_.data(); }
    const double* z() const { return z_.data(); }
    const double* weight() const { return weight_.data(); }
    double* x() { return x_.data(); }
    double* y() { return y_.data(); }
    double* z() { return z_.data(); }
    double* weight() { return weight_.data(); }

  private:
    std::vector<double> x_, y_, z_, weight_;
};

// Of the light from k1: what leaves after one bounce, or what stays between the facets.
enum class FirstBounce { leaves, stays };

// What facets add to R(k1), or to what stays, weights being their masses p dh; g(k1) = g1, g(k2) from the
// tables of `shading`. See Shading::facet_albedo and facet_bounce.
LayerAlbedo sum_albedo(const Shading<double>& shading, dvec3 k1, double g1, int channels,
                       const WeightedDirections& facets, FirstBounce which = FirstBounce::leaves);

// R with F = 1 of three colours, a tint that all share left out, then their (whole - R)+, as the finished
// tables of `shading` hold them; see Shading::diffuse_share.
Values<6> sum_shares(const Shading<double>& shading, const WeightedDirections& directions);

// What multiple bounces spread evenly, and its three colours times F(k); see multibounce.glsl.
Values<4> sum_rests(const Shading<double>& shading, const WeightedDirections& directions);

}  // namespace nacre
