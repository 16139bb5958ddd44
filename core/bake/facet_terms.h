// What facets that are matt themselves show of each other, V of shaders/shared/matt_facets.glsl, as few
// terms.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/stretched_grid.h"
#include "core/bake/workers.h"
#include "core/model/facet_distribution.h"
#include "core/model/shading.h"

namespace nacre {

// Of the tables: nodes along w and rows along psi; classes of terms, and terms of each class.
struct FacetShape {
    int nodes, rows, classes, terms;

    int tables() const { return classes * terms + 1; }  // with that of E
    int size() const { return nodes * rows; }           // of one
    bool operator==(const FacetShape&) const = default;
};

FacetShape facet_shape(Symmetry symmetry);

// The same by sums over a lattice of facets.
class FacetSums {
  public:
    // About so many facets. `shading` holds N, the clamp and the shape of the table of g; it is kept as a
    // reference.
    FacetSums(const FacetDistribution& p, const Shading<double>& shading, std::size_t facets);
    ~FacetSums();

    // Of every two of these directions, row by row; they are unit vectors above the horizon.
    std::vector<double> products(const std::vector<dvec3>& k) const;

  private:
    friend class FacetTerms;
    struct Facets;

    std::unique_ptr<const Facets> facets_;
};

// The terms: its eigenfunctions on directions that lie evenly in (w, psi) but crowd toward grazing, carried
// on to all others by Nystrom's formula.
class FacetTerms {
  public:
    FacetTerms(const FacetDistribution& p, const StretchedGrid& grid, const Shading<double>& shading,
               Quality quality, Workers& workers);
    ~FacetTerms();

    // u of each term.
    std::vector<double> operator()(dvec3 k) const;

    const FacetShape& shape() const { return shape_; }

  private:
    struct Weights;

    void add_class(int index, const std::vector<dvec3>& directions);

    FacetShape shape_;
    FacetSums sums_;
    std::unique_ptr<Weights> weights_;  // of each facet in each term
};

// The direction at w in [0, 1] and at this part of the folded azimuth.
dvec3 direction_at(const StretchedGrid& grid, double w, double part);

// So many, evenly in that part and crowded toward grazing: of one endless sequence, from number `first` on.
std::vector<dvec3> stretched_directions(const StretchedGrid& grid, int first, int count);

}  // namespace nacre
