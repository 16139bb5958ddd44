#include "core/bake/facet_terms.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/facet_lattice.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Row = Eigen::ArrayXf;

constexpr std::size_t facets_draft = 2048, facets_final = 16384;

// Of one class. An eigenvalue below this part of the first is rounding.
constexpr int directions_draft = 64, directions_final = 160;
constexpr double least_part = 1e-7;

// So many rings stand for an isotropic p, and so many harmonics for its V where it is measured: they fall
// with the fourth power.
constexpr std::size_t rings = 1024;
constexpr int harmonics = 48;

// Facets of nearly the same slope become one ring. What p all but lacks is left out.
std::vector<Facet> as_rings(std::vector<Facet> facets) {
    double mass = 0;
    for (const Facet& facet : facets) mass += facet.mass;
    std::erase_if(facets, [&](const Facet& facet) { return facet.mass < 1e-12 * mass; });
    std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.h.z > b.h.z; });
    const std::size_t group = std::max<std::size_t>(facets.size() / rings, 1);
    std::vector<Facet> all;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const dvec3 own{std::hypot(facets[i].h.x, facets[i].h.y), 0, facets[i].h.z};
        if (i % group == 0) all.push_back({dvec3{0}, 0});
        all.back().h += facets[i].mass * own;
        all.back().mass += facets[i].mass;
    }
    for (Facet& ring : all) ring.h = glm::normalize(ring.h);
    return all;
}

}  // namespace

// In columns, in the frame of the tables' axis.
struct FacetSums::Facets {
    Facets(const FacetDistribution& p, const Shading<double>& material, std::size_t count)
        : shading(material),
          symmetry(static_cast<Symmetry>(material.surface.tables.symmetry)),
          axis(material.surface.tables.axis),
          N(material.surface.N) {
        std::vector<Facet> all = facet_lattice(p, std::max<std::size_t>(count / p.lobes().size(), 256));
        if (symmetry == Symmetry::isotropic) all = as_rings(std::move(all));
        const auto size = static_cast<Eigen::Index>(all.size());
        for (Row* column : {&x, &y, &z, &mass}) column->resize(size);
        double sum = 0;
        for (const Facet& facet : all) sum += facet.mass;
        for (Eigen::Index i = 0; i < size; ++i) {
            const Facet& facet = all[static_cast<std::size_t>(i)];
            const dvec3 h = symmetry == Symmetry::isotropic ? facet.h : from_axis(facet.h);
            x[i] = static_cast<float>(h.x);
            y[i] = static_cast<float>(h.y);
            z[i] = static_cast<float>(h.z);
            mass[i] = static_cast<float>(facet.mass / sum);
        }
    }

    dvec3 from_axis(dvec3 k) const { return {axis.x * k.x + axis.y * k.y, axis.x * k.y - axis.y * k.x, k.z}; }

    // (k.h)+ of each; k from the axis.
    Row seen(dvec3 k) const {
        const glm::vec3 v(k);
        return (x * v.x + y * v.y + z * v.z).max(0.0f);
    }

    // The part of (k.h)+ in a class, k from the axis: its mean over the mirrored k with the signs of the
    // class, or of each ring the coefficient of cos(m phi).
    Row part(dvec3 k, int index) const {
        if (symmetry == Symmetry::isotropic) return harmonic(std::hypot(k.x, k.y), k.z, index);
        if (symmetry == Symmetry::none) return seen(k);
        const float across = index == 1 || index == 3 ? -1.0f : 1.0f, along = index >= 2 ? -1.0f : 1.0f;
        Row sum = seen(k) + across * seen({k.x, -k.y, k.z});
        if (symmetry == Symmetry::half) return 0.5f * sum;
        sum += along * (seen({-k.x, k.y, k.z}) + across * seen({-k.x, -k.y, k.z}));
        return 0.25f * sum;
    }

    // Of the integral of (a + b cos(phi))+ cos(m phi) over a ring, normalised so that V of the class is a
    // plain product.
    Row harmonic(double sine, double cosine, int m) const {
        Row row(x.size());
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const double a = cosine * static_cast<double>(z[i]), b = sine * static_cast<double>(x[i]);
            const double turn = b > 0   ? std::clamp(-a / b, -1.0, 1.0)
                                : a > 0 ? -1
                                        : 1;  // cos of where it ends
            const double end = std::acos(turn), first = std::sqrt((1 - turn) * (1 + turn));
            // sin(n end)/n, or end, of n = m - 1, m and m + 1.
            double before = m == 0 ? first : end, here = m == 0 ? end : first;
            double last = 0, sine_n = first;
            for (int n = 1; n < m; ++n) {
                const double next = 2 * turn * sine_n - last;
                last = sine_n;
                sine_n = next;
                before = here;
                here = sine_n / (n + 1);
            }
            const double after = m == 0 ? first : (2 * turn * sine_n - last) / (m + 1);
            row[i] = static_cast<float>((a * here + 0.5 * b * (before + after)) / pi *
                                        (m == 0 ? 1 : std::numbers::sqrt2));
        }
        return row;
    }

    // 1/K; `visible` is the part of class 0, k stands in the surface's frame.
    float over_area(const Row& visible, dvec3 k) const {
        const double g = static_cast<double>((visible * mass).sum());
        return static_cast<float>(
            1 / shading.facet_area(Shading<double>::known_direction(k, g, dvec3{0}), shading.facet_spot(k)));
    }

    const Shading<double>& shading;
    Symmetry symmetry;
    dvec2 axis;
    double N;
    Row x, y, z, mass;
};

FacetSums::FacetSums(const FacetDistribution& p, const Shading<double>& shading, std::size_t facets)
    : facets_(std::make_unique<const Facets>(p, shading, facets)) {}

FacetSums::~FacetSums() = default;

std::vector<double> FacetSums::products(const std::vector<dvec3>& k) const {
    const bool round = facets_->symmetry == Symmetry::isotropic;
    const std::size_t n = k.size();
    std::vector<double> all(n * n);
    std::vector<float> over_area;
    for (const dvec3& at : k)
        over_area.push_back(
            facets_->over_area(round ? facets_->part(at, 0) : facets_->seen(facets_->from_axis(at)), at));
    for (int m = 0; m < (round ? harmonics : 1); ++m) {
        std::vector<Row> rows;
        for (std::size_t i = 0; i < n; ++i)
            rows.push_back((round ? facets_->part(k[i], m) : facets_->seen(facets_->from_axis(k[i]))) *
                           over_area[i]);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                const double turn = std::atan2(k[i].y, k[i].x) - std::atan2(k[j].y, k[j].x);
                all[i * n + j] += facets_->N * (round ? std::cos(m * turn) : 1.0) *
                                  static_cast<double>((rows[i] * rows[j] * facets_->mass).sum());
            }
    }
    return all;
}

struct FacetTerms::Weights {
    std::vector<Eigen::MatrixXf> of_class;  // a row a facet, a column a term
};

// 32 KiB at most. A p without mirror planes needs most rows, an isotropic one the most terms.
FacetShape facet_shape(Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return {.nodes = 65, .rows = 1, .classes = 9, .terms = 4};
        case Symmetry::quarter:
            return {.nodes = 21, .rows = 13, .classes = 4, .terms = 5};
        case Symmetry::half:
            return {.nodes = 19, .rows = 24, .classes = 2, .terms = 8};
        case Symmetry::none:
            break;
    }
    return {.nodes = 15, .rows = 40, .classes = 1, .terms = 12};
}

dvec3 direction_at(const StretchedGrid& grid, double w, double part) {
    return grid.area_direction(w, part * azimuth_cells(grid.shape().nodes_psi, grid.symmetry()));
}

// Roberts 2018, the R2 sequence.
std::vector<dvec3> stretched_directions(const StretchedGrid& grid, int first, int count) {
    constexpr double root = 1.32471795724474602596;  // x^3 = x + 1
    std::vector<dvec3> directions;
    for (int i = first; i < first + count; ++i) {
        const double u = std::fmod(0.5 + i / root, 1.0), v = std::fmod(0.5 + i / (root * root), 1.0);
        directions.push_back(direction_at(grid, 1 - std::pow(1 - u, 1.5), v));
    }
    return directions;
}

FacetTerms::FacetTerms(const FacetDistribution& p, const StretchedGrid& grid, const Shading<double>& shading,
                       Quality quality, Workers& workers)
    : shape_(facet_shape(grid.symmetry())),
      sums_(p, shading, quality == Quality::draft ? facets_draft : facets_final),
      weights_(std::make_unique<Weights>()) {
    const bool draft = quality == Quality::draft;
    const std::vector<dvec3> directions = stretched_directions(
        grid, 1, (draft ? directions_draft : directions_final) * (shape_.classes == 1 ? 2 : 1));
    weights_->of_class.resize(static_cast<std::size_t>(shape_.classes));
    workers.for_each(shape_.classes, [&](int index) { add_class(index, directions); });
}

FacetTerms::~FacetTerms() = default;

void FacetTerms::add_class(int index, const std::vector<dvec3>& directions) {
    const FacetSums::Facets& facets = *sums_.facets_;
    const Row root = (facets.mass * static_cast<float>(facets.N)).sqrt();
    Eigen::MatrixXf rows(static_cast<Eigen::Index>(directions.size()), facets.x.size());
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const dvec3 k = facets.from_axis(directions[i]);
        const float scale = facets.over_area(facets.part(k, 0), directions[i]);
        rows.row(static_cast<Eigen::Index>(i)) = (facets.part(k, index) * root * scale).matrix().transpose();
    }
    const Eigen::MatrixXd products = (rows * rows.transpose()).cast<double>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
    const Eigen::Index size = products.rows();
    Eigen::MatrixXf& weights = weights_->of_class[static_cast<std::size_t>(index)];
    weights = Eigen::MatrixXf::Zero(facets.x.size(), shape_.terms);
    for (int term = 0; term < shape_.terms; ++term) {
        const double value = solver.eigenvalues()[size - 1 - term];
        if (!(value > least_part * solver.eigenvalues()[size - 1])) break;
        const Eigen::VectorXf vector =
            (solver.eigenvectors().col(size - 1 - term) / std::sqrt(value)).cast<float>();
        weights.col(term) = (rows.transpose() * vector).cwiseProduct(root.matrix());
    }
}

std::vector<double> FacetTerms::operator()(dvec3 k) const {
    const FacetSums::Facets& facets = *sums_.facets_;
    const dvec3 from = facets.from_axis(k);
    std::vector<double> values;
    float scale = 0;
    for (int index = 0; index < shape_.classes; ++index) {
        const Row part = facets.part(from, index);
        if (index == 0) scale = facets.over_area(part, k);
        const Eigen::RowVectorXf terms =
            part.matrix().transpose() * weights_->of_class[static_cast<std::size_t>(index)];
        for (int term = 0; term < shape_.terms; ++term)
            values.push_back(static_cast<double>(scale * terms[term]));
    }
    return values;
}

}  // namespace nacre
