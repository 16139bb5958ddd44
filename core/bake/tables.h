// The result of a bake: small tables of g(k) and R(k), and everything else that a renderer needs.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/bake/needs.h"
#include "core/bake/table_size.h"
#include "core/model/facet_distribution.h"
#include "core/model/quadrature.h"
#include "core/model/shading.h"

namespace nacre {

// Error of one quantity over `directions`; 0: not measured.
struct TableError {
    double worst = 0;
    double root_mean_square = 0;
    int directions = 0;
};

// The same of one table, and the worst between two nodes along theta and along azimuth.
struct AxisError {
    TableError all;
    double polar = 0, azimuth = 0;
};

// A size that was tried for a table, and the worst error it showed.
struct TriedSize {
    TableNodes nodes;
    double worst;
};

struct TableErrors {
    TableError area;    // of g, relative: see area_error()
    TableError albedo;  // of R, absolute: with F = 1 and with each Fresnel factor that is baked
    TableError facets;  // of matt facets: see facet_error(); none without them
};

// Of multiple bounces.
struct BounceFigures {
    bool fitted = false;  // tables fitted to random walks; else all is spread evenly
    int walks = 0;        // that they, and the share of the second bounce, come from
    std::optional<double>
        misplaced;           // by the tables: part of all energy that goes to another place than other walks'
    std::size_t floats = 0;  // of `data`
};

// Immutable once baked; shared between threads by shared_ptr<const Tables>. The layout of `data` is that of
// shaders/shared/tables.glsl and lobes.glsl; `shading` points into it.
struct Tables {
    Tables() = default;
    Tables(const Tables&) = delete;
    Tables& operator=(const Tables&) = delete;

    Needs needs;
    std::vector<Omission> omissions;  // what the design does not need
    Quality quality = Quality::final;
    TableSize size;  // chosen by the bake, or requested
    std::shared_ptr<const FacetDistribution> distribution;
    std::shared_ptr<const FacetDistribution> coat_facets;  // of a coat's own highlight; null without one
    std::vector<float> data;
    Shading<double> shading;

    dvec3 mean{0};                                    // H = <h>, p normalised to 1
    double intensity = 1;                             // of the specular term, not in R
    dvec3 mean_albedo{0};                             // AlbedoIntegrals::mean; 0 without R
    double tolerance = 0;                             // that the bake was asked for
    TableErrors errors;                               // measured by the bake, on directions between nodes
    std::optional<BounceFigures> bounces;             // where the design has any
    std::vector<TriedSize> tried_area, tried_albedo;  // on the way to `size`
    double seconds = 0;                               // duration of the request
    double bake_seconds = 0;  // duration of making the tables, for this request or an earlier one

    std::size_t table_floats() const;  // of `data`: the tables without curves and pictures
};

// Error of the tables' g at k, given g itself: relative to max(g, N c), which is what the BRDF divides by (to
// g without clamp), and to at least a twentieth of p's own width there: g is smaller than
// that only where a tilted p turns away almost entirely. Infinite where either g is NaN.
double area_error(const Shading<double>& shading, dvec3 k, double exact);

// The same error of any other approximation `read` of g, so that all methods of storing g
// are measured alike; `shading` holds the design's finished tables, for N, the clamp and p's own width.
double area_error(const Shading<double>& shading, dvec3 k, double read, double exact);

// R at k as the tables hold it, see AlbedoLayout; k.z >= 0.
AlbedoValues read_albedo(const Shading<double>& shading, dvec3 k, int channels);

// Error of that, of the value with the largest; `exact` as AlbedoQuadrature gives it.
double albedo_error(const Shading<double>& shading, dvec3 k, const AlbedoValues& exact, int channels);

// The larger of two errors; NaN counts as infinite.
double worse_error(double a, double b);

// Worst and root mean square; both are infinite where an error is NaN.
TableError summarise(const std::vector<double>& errors);

}  // namespace nacre
