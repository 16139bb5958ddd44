#include "core/bake/bounce_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/bake/albedo.h"
#include "core/bake/momentum_tables.h"
#include "core/bake/table_integral.h"
#include "core/base/stopwatch.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;

// For a draft, for what is spread evenly alone, and for tables.
constexpr int walks_draft = 1024, walks_even = 8192, walks_fitted = 262144;
constexpr std::uint64_t seed = 1, seed_held_out = 2;

// Absolute, of what is spread evenly between two rows of R's tables.
constexpr double rest_tolerance = 1e-6;

// Of E where tints differ.
constexpr double whole_tolerance = 1e-4;

class Adding {
  public:
    Adding(Tables& tables, const StretchedGrid& grid, Workers& workers)
        : tables_(tables),
          shading_(tables.shading),
          grid_(grid),
          workers_(workers),
          first_(tables.data.size()) {}

    void operator()(const Multibounce& model, bool fitted, std::optional<BounceFit>& fit) {
        const int kind = static_cast<int>(model.index()),
                  even = kind_index<Multibounce, RankOneMultibounce>();
        shading_.kinds.multibounce = is_fitted(model) ? even : kind;
        if (shading_.kinds.tint == Tint::varied) add_whole();
        const bool known = fit.has_value();
        const Stopwatch time;
        if (!known) fit = make_fit(fitted);
        if (fit->momentum) {
            add_momentum(*fit->momentum);
            shading_.kinds.multibounce = kind;
        }
        add_factors();
        add_rest();
        if (fit->momentum && shading_.kinds.bounce_factors() > 0) add_spread();
        shading_.surface.bounce_scale = scale(fit->walks);
        if (fit->momentum && !known)
            fit->misplaced = misplaced_energy(shading_, walk_bounces(shading_, *tables_.distribution,
                                                                     walks_fitted, seed_held_out, workers_));
        if (!known) fit->seconds = time.seconds();
        tables_.bake_seconds += fit->seconds;
        // What R and the bounces bring is claimed together.
        if (fit->momentum) tables_.errors.albedo.worst += fit->momentum->error;
        tables_.bounces = BounceFigures{fit->momentum.has_value(), fit->walks.walks, fit->misplaced,
                                        tables_.data.size() - first_};
    }

  private:
    BounceFit make_fit(bool fitted) {
        const int count = fitted                              ? walks_fitted
                          : tables_.quality == Quality::draft ? walks_draft
                                                              : walks_even;
        BounceFit fit{walk_bounces(shading_, *tables_.distribution, count, seed, workers_), {}, {}, 0};
        if (fitted) fit.momentum = fit_momentum(shading_, grid_, fit.walks, workers_);
        fit.walks.pairs = {};
        return fit;
    }

    int append(const std::vector<float>& values) {
        const int offset = static_cast<int>(tables_.data.size());
        tables_.data.insert(tables_.data.end(), values.begin(), values.end());
        shading_.data = tables_.data.data();
        return offset;
    }

    // Tables of values(k) at R's nodes, one after the other.
    template <class ValuesAt>
    int append_tables(int count, const ValuesAt& values_at) {
        const int nodes = albedo_node_count(shading_);
        const auto size = static_cast<std::size_t>(nodes);
        std::vector<float> values(size * static_cast<std::size_t>(count));
        workers_.for_each(nodes, [&](int i) {
            const auto found = values_at(albedo_node(shading_, grid_, i));
            for (int c = 0; c < count; ++c)
                values[static_cast<std::size_t>(c) * size + static_cast<std::size_t>(i)] =
                    static_cast<float>(found[c]);
        });
        return append(values);
    }

    // The same p without tints.
    Shader untinted() const {
        Shader plain = shading_;
        plain.kinds.tint = Tint::none;
        return plain;
    }

    // As R's own tables, G/g with it.
    void add_whole() {
        const Shader plain = untinted();
        const AlbedoQuadrature rule(*tables_.distribution, plain, 0, whole_tolerance);
        shading_.surface.tables.whole_offset = append_tables(1, [&](dvec3 k) {
            const double g = tables_.distribution->projected_area(k), kept = plain.clamped_part(k, g);
            return dvec3{kept > 0 ? rule(k, g)[0] / kept : 0};
        });
    }

    void add_momentum(const MomentumTables& momentum) {
        auto& shape = shading_.surface.tables;
        shape.momentum_nodes = momentum.nodes;
        shape.row_offset = append(momentum.row);
        shape.amplitude_offset = append(momentum.amplitude);
        shape.sum_offset = append(momentum.sum);
        shape.difference_offset = append(momentum.difference);
    }

    // The coarsest rule serves: F is smooth, and the error of its mean is one of a part that is small where
    // it is large.
    void add_factors() {
        const int count = shading_.kinds.bounce_factors();
        if (count == 0) return;
        const int channels = tables_.needs.fresnel_tables;
        const AlbedoLayout layout{channels, shading_.kinds.tint};
        const double any = std::numeric_limits<double>::infinity();
        const AlbedoQuadrature rule(*tables_.distribution, shading_, channels, any);
        const Shader plain = untinted();
        std::optional<AlbedoQuadrature> whole;
        if (layout.tint == Tint::varied) whole.emplace(*tables_.distribution, plain, 0, any);
        const bool linear = shading_.kinds.fresnel_tables() == FresnelTables::linear;
        const dvec3 f0 = shading_.surface.fresnel_a;
        shading_.surface.tables.factor_offset = append_tables(count, [&](dvec3 k) {
            const double g = tables_.distribution->projected_area(k);
            const AlbedoValues values = rule.staying(k, g);
            const double stays = whole ? whole->staying(k, g)[0] : values[0];
            dvec3 f{1};
            for (int c = 0; c < count; ++c) {
                const double full = values[static_cast<std::size_t>(c % layout.full())];
                const double met =
                    layout.factors() == 0
                        ? full
                        : values[static_cast<std::size_t>(layout.full() + c % layout.factors())];
                const double sum = count == 3 && linear ? f0[c] * full + (1 - f0[c]) * met : met;
                if (stays > 0) f[c] = std::clamp(sum / stays, 0.0, 1.0);
            }
            return f;
        });
    }

    void add_rest() {
        const Values<4> sum = integrate_tables<4>(
            shading_, rest_tolerance, workers_,
            [&](const WeightedDirections& directions) { return sum_rests(shading_, directions); });
        constexpr double nothing = 1e-9;
        const bool any = sum[0] > nothing * pi;
        shading_.surface.bounce_even = any ? 1 / sum[0] : 0;
        shading_.surface.bounce_mean = any ? dvec3{sum[1], sum[2], sum[3]} / sum[0] : dvec3{0};
    }

    void add_spread() {
        const int count = shading_.kinds.bounce_factors(), offset = shading_.surface.tables.factor_offset;
        const auto factor = [&](dvec3 k) {
            const auto spot = shading_.albedo_spot(k, shading_.table_spot(k));
            dvec3 f{1};
            for (int c = 0; c < count; ++c) f[c] = shading_.bounce_table(spot, offset, c);
            return f;
        };
        const std::vector<dvec3> rows = momentum_rows(shading_, grid_, factor, workers_);
        std::vector<float> values;
        for (int c = 0; c < count; ++c)
            for (const dvec3& row : rows) values.push_back(static_cast<float>(row[c]));
        shading_.surface.tables.spread_offset = append(values);
    }

    // C: e2/(1 - Fm (1 - e2)) of each colour.
    dvec3 scale(const BounceWalks& walks) const {
        const dvec3 f0 = shading_.surface.fresnel_a;
        dvec3 middle = walks.fresnel;
        if (shading_.kinds.fresnel_tables() == FresnelTables::linear)
            middle = f0 * walks.tint + (1.0 - f0) * walks.schlick;
        if (shading_.kinds.fresnel_tables() == FresnelTables::none) middle = walks.tint;
        if (shading_.kinds.tint == Tint::shared) middle *= shading_.layers[0].tint;
        return walks.second / (1.0 - middle * (1 - walks.second));
    }

    Tables& tables_;
    Shader& shading_;
    const StretchedGrid& grid_;
    Workers& workers_;
    std::size_t first_;
};

}  // namespace

void add_bounce_tables(Tables& tables, const StretchedGrid& grid, const Multibounce& model, bool fitted,
                       std::optional<BounceFit>& fit, Workers& workers) {
    Adding(tables, grid, workers)(model, fitted, fit);
}

}  // namespace nacre
