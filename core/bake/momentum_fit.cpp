#include "core/bake/momentum_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/bake/bounce_directions.h"
#include "core/bake/momentum_tables.h"
#include "core/bake/symmetry.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;

// Nodes from 0 to 2: of an isotropic p, along a line, and of any other.
constexpr int nodes_line = 65, nodes_plane = 17;

constexpr int rounds = 40;                             // of the likelihood
constexpr int sweeps = 4;                              // of a's scaling, a round
constexpr int sweeps_last = 80;                        // once the tables stand
constexpr int few = 512, several = 2048, many = 8192;  // directions that a row is summed over
constexpr double least = 1e-4, most = 10;  // of a: where what is to come back fits no walk it would run away
constexpr double grazing = 0.15;    // a cosine, below which what comes back turns faster than the tables can
constexpr double smoothing = 0.04;  // of a texel to each of those beside it, a round
constexpr int compared = 500;       // directions by which the tables are measured
constexpr int watched = 4096;       // directions in which no more may come back than is to
constexpr std::size_t pairs_fitted = 262144;  // of directions that the whole is summed over
constexpr double floor_part = 0.001;  // of the kernel, the same everywhere: a's scaling then has a solution

// Of what comes back toward k, what the tables are to bring.
double brought_part(dvec3 k) { return std::min(k.z / grazing, 1.0); }

// Where a pair of directions lies in both tables: indices into their texels, one table after the other.
struct PairSpots {
    std::array<int, 8> at;
    std::array<float, 8> part;
    double weight;  // as a part of what is to come back is left out where light grazes

    double read(const std::vector<double>& texels) const {
        double sum = 0;
        for (std::size_t i = 0; i < 8; ++i)
            sum += static_cast<double>(part[i]) * texels[static_cast<std::size_t>(at[i])];
        return sum;
    }
    void add(double value, std::vector<double>& texels) const {
        for (std::size_t i = 0; i < 8; ++i)
            texels[static_cast<std::size_t>(at[i])] += static_cast<double>(part[i]) * value;
    }
};

void place_spot(const Shader::MomentumSpot& spot, int offset, std::size_t first, PairSpots& spots) {
    const double part[4] = {(1 - spot.x) * (1 - spot.y), spot.x * (1 - spot.y), (1 - spot.x) * spot.y,
                            spot.x * spot.y};
    const int at[4] = {spot.first, spot.first + 1, spot.second, spot.second + 1};
    for (std::size_t i = 0; i < 4; ++i) {
        spots.at[first + i] = offset + at[i];
        spots.part[first + i] = static_cast<float>(part[i]);
    }
}

// Where a direction lies in the table of a.
struct AmplitudeSpot {
    std::array<int, 4> at;
    std::array<double, 4> part;

    double read(const std::vector<double>& texels) const {
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i) sum += part[i] * texels[static_cast<std::size_t>(at[i])];
        return sum;
    }
};

// The tables while they are fitted.
class Fit {
  public:
    Fit(const Shader& shading, const StretchedGrid& grid, Workers& workers)
        : shading_(shading), workers_(workers) {
        auto& shape = shading_.surface.tables;
        shape.momentum_nodes = shape.symmetry == Shader::SYMMETRY_ISOTROPIC ? nodes_line : nodes_plane;
        sum_size_ = size_of(false);
        texels_.assign(static_cast<std::size_t>(sum_size_ + size_of(true)), 1.0);
        amplitude_.assign(static_cast<std::size_t>(sum_size_), 1.0);
        for (int i = 0; i < albedo_node_count(shading_); ++i)
            nodes_.push_back(albedo_node(shading_, grid, i));
    }

    MomentumTables operator()(const BounceWalks& walks) {
        const std::vector<PairSpots> seen = spots_of(walks.pairs);
        const std::vector<BouncePair> anywhere = even_pairs(pairs_fitted);
        const std::vector<PairSpots> all = spots_of(anywhere);
        const std::vector<dvec3> directions = even_directions(few);
        for (int round = 0; round < rounds && !seen.empty(); ++round) {
            workers_.check();
            likelier(seen, anywhere, all, static_cast<double>(walks.walks));
            smooth_table(texels_, 0, momentum_size(shading_, false), smoothing);
            smooth_table(texels_, sum_size_, momentum_size(shading_, true), smoothing);
            if (round % 2 == 1) scale(directions, sweeps);
        }
        if (seen.empty()) texels_.assign(texels_.size(), 0.0);
        add_floor(anywhere, all);
        return finished();
    }

  private:
    int size_of(bool difference) const {
        const glm::ivec2 size = momentum_size(shading_, difference);
        return size.x * size.y;
    }

    PairSpots spots(dvec3 k1, dvec3 k2) const {
        PairSpots spots{{}, {}, brought_part(k1) * brought_part(k2)};
        place_spot(shading_.momentum_spot(dvec2(k1) + dvec2(k2), false), 0, 0, spots);
        place_spot(shading_.momentum_spot(dvec2(k1) - dvec2(k2), true), sum_size_, 4, spots);
        return spots;
    }

    std::vector<PairSpots> spots_of(const std::vector<BouncePair>& pairs) const {
        std::vector<PairSpots> all;
        all.reserve(pairs.size());
        for (const BouncePair& pair : pairs) all.push_back(spots(pair.k1, pair.k2));
        return all;
    }

    AmplitudeSpot amplitude_spot(dvec3 k) const {
        const auto spot = shading_.momentum_spot(dvec2(k) * (2 / (1 + k.z)), false);
        return {{spot.first, spot.first + 1, spot.second, spot.second + 1},
                {(1 - spot.x) * (1 - spot.y), spot.x * (1 - spot.y), (1 - spot.x) * spot.y, spot.x * spot.y}};
    }

    double amplitude(dvec3 k) const { return amplitude_spot(k).read(amplitude_); }

    // What the tables are to bring: 1 - E, but for grazing light.
    double lost(dvec3 k) const {
        const auto spot = shading_.table_spot(k);
        const double kept = shading_.clamped_part(k, shading_.projected_area(k, spot));
        const double rest = std::max(1 - shading_.bounce_whole(shading_.albedo_spot(k, spot)) * kept, 0.0);
        return rest * brought_part(k);
    }

    std::vector<double> lost(const std::vector<dvec3>& directions) const {
        std::vector<double> all;
        for (const dvec3 k : directions) all.push_back(lost(k));
        return all;
    }

    // One step of expectation and maximisation: each texel times what was seen of it over what it makes
    // expect.
    void likelier(const std::vector<PairSpots>& seen, const std::vector<BouncePair>& anywhere,
                  const std::vector<PairSpots>& all, double walks) {
        std::vector<double> found(texels_.size()), expected(texels_.size());
        for (const PairSpots& pair : seen)
            pair.add(pair.weight * (pi / walks) / std::max(pair.read(texels_), 1e-300), found);
        const double each = pi * pi / static_cast<double>(all.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i].add(each * amplitude(anywhere[i].k1) * amplitude(anywhere[i].k2), expected);
        for (std::size_t i = 0; i < texels_.size(); ++i)
            texels_[i] = expected[i] > 0 ? texels_[i] * found[i] / expected[i] : 0;
    }

    void add_floor(const std::vector<BouncePair>& anywhere, const std::vector<PairSpots>& all) {
        double whole = 0, even = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double weight = amplitude(anywhere[i].k1) * amplitude(anywhere[i].k2);
            whole += weight * all[i].read(texels_);
            even += weight;
        }
        if (!(even > 0)) return;
        for (int i = 0; i < sum_size_; ++i) texels_[static_cast<std::size_t>(i)] += floor_part * whole / even;
    }

    // qs + qd of each of `from` with each of `to`, times c' dk'.
    std::vector<float> kernel(const std::vector<dvec3>& from, const std::vector<dvec3>& to) {
        std::vector<float> values(from.size() * to.size());
        const double each = pi / static_cast<double>(to.size());
        workers_.for_each(static_cast<int>(from.size()), [&](int row) {
            const auto at = static_cast<std::size_t>(row);
            for (std::size_t j = 0; j < to.size(); ++j)
                values[at * to.size() + j] = static_cast<float>(each * spots(from[at], to[j]).read(texels_));
        });
        return values;
    }

    // What the tables bring to each of `from`.
    std::vector<double> rows(const std::vector<float>& kernel, const std::vector<dvec3>& from,
                             const std::vector<dvec3>& to) const {
        std::vector<double> a, sums;
        for (const dvec3 k : to) a.push_back(amplitude(k));
        for (std::size_t i = 0; i < from.size(); ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < a.size(); ++j)
                sum += static_cast<double>(kernel[i * a.size() + j]) * a[j];
            sums.push_back(sum * amplitude(from[i]));
        }
        return sums;
    }

    // Each node of a by what is to come back around it over what does.
    void scale(const std::vector<dvec3>& directions, int count) {
        const std::vector<float> values = kernel(directions, directions);
        const std::vector<double> wanted = lost(directions);
        for (int sweep = 0; sweep < count; ++sweep) {
            const std::vector<double> brought = rows(values, directions, directions);
            std::vector<double> want(amplitude_.size()), bring(amplitude_.size());
            for (std::size_t i = 0; i < directions.size(); ++i) {
                const AmplitudeSpot spot = amplitude_spot(directions[i]);
                for (std::size_t n = 0; n < 4; ++n) {
                    want[static_cast<std::size_t>(spot.at[n])] += spot.part[n] * wanted[i];
                    bring[static_cast<std::size_t>(spot.at[n])] += spot.part[n] * brought[i];
                }
            }
            for (std::size_t i = 0; i < amplitude_.size(); ++i)
                if (bring[i] > 0)
                    amplitude_[i] = std::clamp(amplitude_[i] * std::sqrt(want[i] / bring[i]), least, most);
        }
    }

    // Scaled for good, and nowhere more than is to come back.
    MomentumTables finished() {
        const std::vector<dvec3> directions = even_directions(several);
        scale(directions, sweeps_last);
        const std::vector<dvec3> places = watched_directions(watched);
        const std::vector<double> wanted = lost(places),
                                  brought = rows(kernel(places, directions), places, directions);
        std::vector<double> limits(amplitude_.size(), 1.0);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const AmplitudeSpot spot = amplitude_spot(places[i]);
            for (std::size_t n = 0; n < 4; ++n)
                if (double& limit = limits[static_cast<std::size_t>(spot.at[n])];
                    spot.part[n] > 0 && brought[i] > wanted[i])
                    limit = std::min(limit, wanted[i] / brought[i]);
        }
        for (std::size_t i = 0; i < limits.size(); ++i) amplitude_[i] *= limits[i];
        const auto split = texels_.begin() + sum_size_;
        MomentumTables tables{shading_.surface.tables.momentum_nodes,
                              over_amplitude(nodes_),
                              {amplitude_.begin(), amplitude_.end()},
                              {texels_.begin(), split},
                              {split, texels_.end()}};
        tables.error = error_of(tables.row);
        return tables;
    }

    // Of what they bring in directions between R's nodes, as it is read there.
    double error_of(const std::vector<float>& row) {
        Shader reader = shading_;
        reader.data = row.data();
        reader.surface.tables.row_offset = 0;
        const std::vector<dvec3> places = even_directions(compared);
        const std::vector<float> exact = over_amplitude(places);
        double worst = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const dvec3 k = places[i];
            const double read = reader.momentum_row(shading_.albedo_spot(k, shading_.table_spot(k)));
            worst = std::max(worst, amplitude(k) * std::fabs(read - static_cast<double>(exact[i])));
        }
        return worst;
    }

    // What they bring to each of `from`, over a there.
    std::vector<float> over_amplitude(const std::vector<dvec3>& from) {
        const std::vector<dvec3> directions = even_directions(many);
        std::vector<double> a;
        for (const dvec3 k : directions) a.push_back(amplitude(k) * (pi / many));
        std::vector<float> sums(from.size());
        workers_.for_each(static_cast<int>(from.size()), [&](int i) {
            const auto at = static_cast<std::size_t>(i);
            double sum = 0;
            for (std::size_t j = 0; j < directions.size(); ++j)
                sum += spots(from[at], directions[j]).read(texels_) * a[j];
            sums[at] = static_cast<float>(sum);
        });
        return sums;
    }

    Shader shading_;
    Workers& workers_;
    int sum_size_ = 0;
    std::vector<double> texels_;     // of the sum, then of the difference
    std::vector<double> amplitude_;  // a, over the same nodes as the sum
    std::vector<dvec3> nodes_;       // of R's tables
};

}  // namespace

MomentumTables fit_momentum(const Shading<double>& shading, const StretchedGrid& grid,
                            const BounceWalks& walks, Workers& workers) {
    return Fit(shading, grid, workers)(walks);
}

}  // namespace nacre
