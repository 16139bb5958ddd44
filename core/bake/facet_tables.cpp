#include "core/bake/facet_tables.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/bake/bounce_directions.h"
#include "core/bake/bounce_walks.h"
#include "core/base/stopwatch.h"
#include "core/model/facet_walks.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;

struct Effort {
    int samples;     // a cell and axis, that the tables are fitted to
    int directions;  // that E is summed over
    int walks;
    int measured;        // directions, every two of which are a pair
    std::size_t facets;  // by which they are measured
};

constexpr Effort draft{2, 256, 2048, 12, 8192}, final{3, 2048, 32768, 32, 65536};

// Of <1 - E>, how much the samples at n weigh in the fit, and by how little it is kept apart from singular.
constexpr int rest_directions = 4096;
constexpr double weight_at_normal = 1e3, ridge = 1e-9;

// Where the directions begin by which tables are measured: past all that terms are made of.
constexpr int held_out = 1024;

// Where a sample lies between the nodes of a table: four of them, each with its weight.
struct Corners {
    std::array<Eigen::Index, 4> node;
    std::array<double, 4> weight;
};

class Fit {
  public:
    Fit(const FacetTerms& terms, const StretchedGrid& grid, int samples)
        : terms_(terms),
          shape_(terms.shape()),
          grid_(grid),
          samples_(samples),
          cells_(azimuth_cells(shape_.rows, grid.symmetry())),
          columns_((shape_.nodes - 1) * samples + 1),
          // A closed circle ends where it begins.
          rows_(grid.symmetry() == Symmetry::isotropic ? 1
                : grid.symmetry() == Symmetry::none    ? cells_ * samples
                                                       : cells_ * samples + 1) {}

    // The nodes whose bilinear interpolant is closest to the terms: its mean square error is a sixth of that
    // of nodes that hold their own values. Table by table, row by row.
    std::vector<float> operator()(Workers& workers) const {
        const int count = columns_ * rows_, terms = shape_.tables() - 1;
        std::vector<std::vector<double>> values(static_cast<std::size_t>(count));
        workers.for_each(count, [&](int i) { values[static_cast<std::size_t>(i)] = terms_(direction(i)); });
        Eigen::MatrixXd normal = ridge * Eigen::MatrixXd::Identity(shape_.size(), shape_.size());
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(shape_.size(), terms);
        for (int i = 0; i < count; ++i) {
            const Corners at = corners(i);
            const double weight = column(i) == 0 ? weight_at_normal : 1;
            const Eigen::Map<const Eigen::RowVectorXd> own(values[static_cast<std::size_t>(i)].data(), terms);
            for (std::size_t a = 0; a < 4; ++a) {
                for (std::size_t b = 0; b < 4; ++b)
                    normal(at.node[a], at.node[b]) += weight * at.weight[a] * at.weight[b];
                right.row(at.node[a]) += weight * at.weight[a] * own;
            }
        }
        const Eigen::MatrixXd nodes = normal.ldlt().solve(right);
        std::vector<float> table;
        for (Eigen::Index term = 0; term < terms; ++term)
            for (Eigen::Index node = 0; node < shape_.size(); ++node)
                table.push_back(static_cast<float>(nodes(node, term)));
        return table;
    }

  private:
    int column(int i) const { return i % columns_; }
    int row(int i) const { return i / columns_; }

    dvec3 direction(int i) const {
        return direction_at(grid_, column(i) / (columns_ - 1.0),
                            rows_ == 1 ? 0 : row(i) / static_cast<double>(cells_ * samples_));
    }

    Corners corners(int i) const {
        const int left = std::min(column(i) / samples_, shape_.nodes - 2);
        const int first = std::min(row(i) / samples_, std::max(cells_ - 1, 0));
        const int second = shape_.rows == 1 ? 0 : (first + 1) % shape_.rows;
        const double s = column(i) / static_cast<double>(samples_) - left,
                     t = row(i) / static_cast<double>(samples_) - first;
        const auto node = [&](int at, int along) { return Eigen::Index{at} * shape_.nodes + along; };
        return {{node(first, left), node(first, left + 1), node(second, left), node(second, left + 1)},
                {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
    }

    const FacetTerms& terms_;
    FacetShape shape_;
    const StretchedGrid& grid_;
    int samples_, cells_, columns_, rows_;
};

class Making {
  public:
    Making(Tables& tables, const StretchedGrid& grid, Workers& workers)
        : tables_(tables), shading_(tables.shading), grid_(grid), workers_(workers) {}

    FacetTables operator()() {
        const Effort effort = tables_.quality == Quality::draft ? draft : final;
        const FacetTerms terms(*tables_.distribution, grid_, shading_, tables_.quality, workers_);
        FacetTables made;
        made.shape = terms.shape();
        made.values = Fit(terms, grid_, effort.samples)(workers_);
        place(made);
        const std::vector<float> whole = albedos(made.shape, effort.directions);
        made.values.insert(made.values.end(), whole.begin(), whole.end());
        tables_.data.insert(tables_.data.end(), whole.begin(), whole.end());
        shading_.data = tables_.data.data();
        made.even = even();
        made.second = second(effort.walks);
        made.error = measured(effort);
        return made;
    }

    void place(const FacetTables& made) {
        auto& shape = shading_.surface.tables;
        shape.facet_offset = static_cast<int>(tables_.data.size());
        shape.facet_nodes = made.shape.nodes;
        shape.facet_rows = made.shape.rows;
        shape.facet_classes = made.shape.classes;
        shape.facet_terms = made.shape.terms;
        tables_.data.insert(tables_.data.end(), made.values.begin(), made.values.end());
        shading_.data = tables_.data.data();
    }

  private:
    Shader::Direction direction(dvec3 k) const {
        return Shader::known_direction(k, shading_.projected_area(k, shading_.table_spot(k)), dvec3{0});
    }

    // E at each node.
    std::vector<float> albedos(const FacetShape& shape, int count) const {
        std::vector<Shader::Direction> to;
        std::vector<Shader::FacetSpot> spots;
        for (const dvec3 k : even_directions(count)) {
            to.push_back(direction(k));
            spots.push_back(shading_.facet_spot(k));
        }
        std::vector<float> values(static_cast<std::size_t>(shape.size()));
        const int cells = azimuth_cells(shape.rows, grid_.symmetry());
        workers_.for_each(shape.size(), [&](int i) {
            const double part = shape.rows == 1 ? 0 : i / shape.nodes / static_cast<double>(cells);
            const dvec3 k = direction_at(grid_, i % shape.nodes / (shape.nodes - 1.0), part);
            const auto from = direction(k);
            const auto spot = shading_.facet_spot(k);
            double sum = 0;
            for (std::size_t j = 0; j < to.size(); ++j)
                sum += shading_.facet_visibility(from, to[j], spot, spots[j]);
            values[static_cast<std::size_t>(i)] =
                static_cast<float>(std::min(sum / static_cast<double>(count), 1.0));
        });
        return values;
    }

    double even() const {
        double sum = 0;
        for (const dvec3 k : even_directions(rest_directions))
            sum += shading_.facet_rest(shading_.facet_spot(k));
        constexpr double nothing = 1e-9;
        const double mean = sum / rest_directions;
        return mean > nothing ? 1 / (pi * mean) : 0;
    }

    // By walks of two bounces.
    double second(int count) const {
        constexpr int at_once = 1024;
        const dvec3 mean = tables_.distribution->mean();
        const auto area = [&](dvec3 k) { return area_everywhere(shading_, mean, k); };
        std::vector<std::array<int, 2>> parts(static_cast<std::size_t>(count / at_once));
        workers_.for_each(count / at_once, [&](int i) {
            Random random(static_cast<std::uint64_t>(i) + 1);
            std::vector<dvec3> from;
            for (int j = 0; j < at_once; ++j) from.push_back(cosine_sample(random));
            FacetWalks walks(*tables_.distribution,
                             facet_walk(static_cast<std::size_t>(shading_.kinds.masking)), shading_.surface.N,
                             area, FacetScatter::matt);
            walks.enter(from, random);
            const auto meet = [](FacetWalks::Walk&, dvec3) {};
            walks.bounce(random, meet, [](const FacetWalks::Walk&, dvec3) {});
            auto& [kept, left] = parts[static_cast<std::size_t>(i)];
            kept = static_cast<int>(walks.inside().size());
            walks.bounce(random, meet, [&left = left](const FacetWalks::Walk&, dvec3) { ++left; });
        });
        int kept = 0, left = 0;
        for (const auto& part : parts) {
            kept += part[0];
            left += part[1];
        }
        // Facets on edge keep light for so long that none of the walks may have left.
        return kept > 0 ? std::max<double>(left, 0.5) / static_cast<double>(kept) : 1;
    }

    // On directions all round the circle.
    TableError measured(const Effort& effort) const {
        std::vector<dvec3> k = stretched_directions(grid_, held_out, effort.measured);
        const dvec2 axis = grid_.shape().axis;
        for (std::size_t i = 0; i < k.size(); ++i) {
            const dvec2 from{axis.x * k[i].x + axis.y * k[i].y, axis.x * k[i].y - axis.y * k[i].x};
            dvec2 turned = from;
            if (grid_.symmetry() == Symmetry::isotropic) {
                const double phi = 2 * pi * std::fmod(static_cast<double>(i) * std::numbers::phi, 1.0);
                turned = glm::length(from) * dvec2{std::cos(phi), std::sin(phi)};
            }
            if (grid_.symmetry() == Symmetry::quarter && i % 2 == 1) turned.x = -turned.x;
            if ((grid_.symmetry() == Symmetry::quarter || grid_.symmetry() == Symmetry::half) &&
                i / 2 % 2 == 1)
                turned.y = -turned.y;
            k[i] = {axis.x * turned.x - axis.y * turned.y, axis.y * turned.x + axis.x * turned.y, k[i].z};
        }
        const FacetSums sums(*tables_.distribution, shading_, effort.facets);
        const std::vector<double> exact = sums.products(k);
        std::vector<double> errors;
        for (std::size_t i = 0; i < k.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j)
                errors.push_back(
                    std::fabs(shading_.facet_product(shading_.facet_spot(k[i]), shading_.facet_spot(k[j])) -
                              exact[i * k.size() + j]));
        return summarise(errors);
    }

    Tables& tables_;
    Shader& shading_;
    const StretchedGrid& grid_;
    Workers& workers_;
};

}  // namespace

void add_facet_tables(Tables& tables, const StretchedGrid& grid, std::optional<FacetTables>& known,
                      Workers& workers) {
    Making making(tables, grid, workers);
    if (known) {
        making.place(*known);
    } else {
        const Stopwatch time;
        known = making();
        known->seconds = time.seconds();
    }
    tables.bake_seconds += known->seconds;
    Shader::Surface& surface = tables.shading.surface;
    surface.facet_even = known->even;
    const dvec3 albedo = surface.albedo;
    surface.facet_scale = albedo * albedo * known->second / (1.0 - albedo * (1 - known->second));
    tables.errors.facets = known->error;
}

double facet_error(const Shading<double>& shading, dvec3 k1, dvec3 k2, double exact) {
    double part = 1;  // G1 G2/(K1 K2)
    for (const dvec3 k : {k1, k2}) {
        const auto a = Shader::known_direction(k, shading.projected_area(k, shading.table_spot(k)), dvec3{0});
        const double G = shading.kinds.clamp ? std::max(a.g, shading.surface.N * k.z) : a.g;
        part *= G / shading.facet_area(a, shading.facet_spot(k));
    }
    return std::fabs(shading.facet_product(shading.facet_spot(k1), shading.facet_spot(k2)) - part * exact);
}

}  // namespace nacre
