#include "core/bake/coat_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bounce_directions.h"
#include "core/bake/coat_light.h"
#include "core/bake/coat_lobe.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;

struct Effort {
    int nodes;       // of the tables, along the root of the cosine
    int rows;        // of them in a quarter turn; where p leans twice as many, of half as many facets
    int inner;       // nodes of the light inside, which has half the rows
    int facets;      // a lobe
    int directions;  // by which the rest is summed
};

constexpr Effort draft{9, 2, 9, 512, 64}, final{33, 6, 33, 4096, 512};
constexpr int even_directions_count = 4096;

int row_count(Symmetry symmetry, int quarter) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return 1;
        case Symmetry::quarter:
            return quarter + 1;
        case Symmetry::half:
            return 2 * quarter + 1;
        case Symmetry::none:
            break;
    }
    return 4 * quarter;
}

class Making {
  public:
    Making(Tables& tables, const StretchedGrid& grid, Workers& workers)
        : tables_(tables),
          shading_(tables.shading),
          grid_(grid),
          workers_(workers),
          effort_(tables.quality == Quality::draft ? draft : final) {}

    void operator()(const CoatLobe& lobe) {
        auto& shape = shading_.surface.tables;
        shape.coat_offset = static_cast<int>(tables_.data.size());
        shape.coat_albedo_nodes = coat_albedo_nodes;
        shape.coat_nodes = effort_.nodes;
        const int quarter = leans() ? 2 * effort_.rows : effort_.rows;
        shape.coat_rows = row_count(grid_.symmetry(), quarter);
        append(lobe.albedo);
        CoatLightIntegral light(*tables_.distribution, shading_,
                                static_cast<std::size_t>(leans() ? effort_.facets / 2 : effort_.facets),
                                effort_.directions);
        const int inner_rows = row_count(grid_.symmetry(), quarter / 2);
        std::vector<dvec2> azimuths;
        for (int row = 0; row < inner_rows; ++row) azimuths.push_back(azimuth(row, inner_rows));
        light.solve(effort_.inner, azimuths, workers_);
        append(nodes(light));
    }

    // 1/E, on what the finished tables hold.
    dvec3 even() const {
        const double ior = shading_.surface.coat_ior;
        dvec3 sum{0};
        for (const dvec3 k : even_directions(even_directions_count)) {
            const auto a = shading_.direction(k);
            sum += a.passed * a.inner;
        }
        sum *= pi / (ior * ior * even_directions_count);
        dvec3 even{0};
        for (int c = 0; c < 3; ++c) even[c] = sum[c] > 1e-12 ? 1 / sum[c] : 0;
        return even;
    }

  private:
    bool leans() const { return grid_.symmetry() == Symmetry::half || grid_.symmetry() == Symmetry::none; }

    // Of the surface, at a row of so many.
    dvec2 azimuth(int row, int rows) const {
        const auto& shape = shading_.surface.tables;
        const dvec2 e = azimuth_at_rho(row_turns(row, rows, grid_.symmetry()), shading_);
        return {shape.axis.x * e.x - shape.axis.y * e.y, shape.axis.y * e.x + shape.axis.x * e.y};
    }

    void append(const std::vector<float>& values) {
        tables_.data.insert(tables_.data.end(), values.begin(), values.end());
        shading_.data = tables_.data.data();
    }

    // u, then b, each colour.
    std::vector<float> nodes(const CoatLightIntegral& light) const {
        const auto& shape = shading_.surface.tables;
        const std::size_t size = static_cast<std::size_t>(shape.coat_nodes * shape.coat_rows);
        std::vector<float> values(6 * size);
        workers_.for_each(static_cast<int>(size), [&](int i) {
            const double at = i % shape.coat_nodes / (shape.coat_nodes - 1.0);
            const CoatLight leaves = light(inside_direction(
                at, azimuth(i / shape.coat_nodes, shape.coat_rows), shading_.surface.coat_ior));
            for (std::size_t c = 0; c < 3; ++c) {
                values[c * size + static_cast<std::size_t>(i)] =
                    static_cast<float>(leaves.whole()[static_cast<int>(c)]);
                values[(3 + c) * size + static_cast<std::size_t>(i)] =
                    static_cast<float>(leaves.again[static_cast<int>(c)]);
            }
        });
        return values;
    }

    Tables& tables_;
    Shader& shading_;
    const StretchedGrid& grid_;
    Workers& workers_;
    Effort effort_;
};

bool is_lobe_of(const CoatLobe& lobe, const Coat& coat, const ShaderCoat& numbers) {
    return lobe.kind == coat.index() && lobe.coat.width == numbers.width && lobe.coat.ior == numbers.ior;
}

}  // namespace

void add_coat_tables(Tables& tables, const StretchedGrid& grid, const Coat& coat,
                     std::optional<CoatLobe>& known, Workers& workers) {
    Shader& shading = tables.shading;
    const ShaderCoat numbers = std::visit([](const auto& kind) { return kind.shader(); }, coat);
    shading.surface.coat_width = numbers.width;
    shading.surface.coat_ior = numbers.ior;
    shading.surface.coat_depth = numbers.depth;
    shading.kinds.coat = static_cast<int>(coat.index());
    if (!known || !is_lobe_of(*known, coat, numbers))
        known = CoatLobe{coat.index(), numbers, coat_albedo_table(shading, workers), coat_facets(coat)};
    known->coat = numbers;
    tables.coat_facets = known->facets;
    Making making(tables, grid, workers);
    // What lies beneath is read as such.
    shading.kinds.coat = kind_index<Coat, NoCoat>();
    making(*known);
    shading.kinds.coat = static_cast<int>(coat.index());
    shading.surface.coat_even = making.even();
}

}  // namespace nacre
