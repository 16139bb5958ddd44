#include "core/formats/rgl_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/bake/brdf.h"
#include "core/bake/workers.h"
#include "core/formats/rgl_place.h"
#include "core/formats/rgl_shape.h"
#include "core/image/luminance.h"

namespace nacre {
namespace {

using std::numbers::pi;

// A warp spreads points by ndf(m)^warp_power (m.wi)+, since what changes between the normal distribution's
// peak and its tail wants points as well, and by an even part so that no region is stretched thin. Both were
// chosen by the error of presets: 0.85 and 0.1 misplaced 7 to 28 % less light than 1 and 0.25 on ggx-steel,
// brushed-gold and star.
constexpr double warp_power = 0.85, even_share = 0.15;

constexpr double lowest = 0.02;           // cosine that stands for grazing incidence
constexpr double least_luminance = 1e-4;  // of the largest: a reader draws by it, and wants it above 0

// Solid angle of facets per area of the tables there.
double spread_at(double x) { return 2 * pi * pi * x * std::sin(0.5 * pi * x * x); }

class Warp {
  public:
    Warp(const RglShape& shape, dvec3 wi, glm::ivec2 nodes) : shape_(shape), wi_(wi) {
        std::vector<double> values(static_cast<std::size_t>(nodes.x * nodes.y));
        double seen_sum = 0, even_sum = 0;
        const auto visit = [&](const auto& at) {
            for (int y = 0; y < nodes.y; ++y)
                for (int x = 0; x < nodes.x; ++x)
                    at(static_cast<std::size_t>(y * nodes.x + x),
                       dvec2{unit_place(x, nodes.x), unit_place(y, nodes.y)});
        };
        visit([&](std::size_t, dvec2 place) {
            // The outermost nodes stand for half of what those inside do.
            const double weight =
                (place.x == 1 ? 0.5 : 1) * (place.y == 0 || place.y == 1 ? 0.5 : 1) * spread_at(place.x);
            seen_sum += weight * seen(rgl_facet(place));
            even_sum += weight;
        });
        even_ = (seen_sum > 0 ? even_share : 1) / even_sum;
        seen_ = seen_sum > 0 ? (1 - even_share) / seen_sum : 0;
        visit([&](std::size_t i, dvec2 place) {
            values[i] = spread_at(place.x) * per_solid_angle(rgl_facet(place));
        });
        density_.emplace(nodes, std::move(values));
    }

    // Of the points that it spreads, up to a factor.
    double per_solid_angle(dvec3 m) const { return seen_ * seen(m) + even_; }

    const SquareDensity& density() const { return *density_; }

  private:
    double seen(dvec3 m) const {
        return std::pow(shape_.ndf(m), warp_power) * std::max(0.0, glm::dot(m, wi_));
    }

    const RglShape& shape_;
    dvec3 wi_;
    double seen_ = 0, even_ = 0;
    std::optional<SquareDensity> density_;
};

std::vector<double> azimuths(int count) {
    if (count == 1) return {0};
    std::vector<double> phi;
    for (int i = 0; i < count; ++i) phi.push_back((2 * unit_place(i, count) - 1) * pi);
    return phi;
}

class Maker {
  public:
    Maker(const RglShape& shape, RglTables& result) : shape_(shape), result_(result) {}

    void fill_normals() const {
        fill(result_.size.normals, result_.ndf, [&](dvec3 m) { return shape_.ndf(m); });
        fill(result_.size.areas, result_.sigma, [&](dvec3 k) { return shape_.sigma(k); });
    }

    SquareDensity fill_incident(std::size_t incident) const {
        const std::size_t elevations = result_.theta.size();
        const double theta = std::min(result_.theta[incident % elevations], std::acos(lowest));
        const dvec3 wi = spherical(theta, result_.phi[incident / elevations]);
        const Warp warp(shape_, wi, result_.size.warp);
        const auto from = shape_.direction(wi);
        const double sigma = result_.sigma_at(wi);
        const glm::ivec2 nodes = result_.size.values;
        const auto begin = static_cast<std::ptrdiff_t>(result_.values_of(incident));
        const auto values = result_.values.begin() + begin;
        const auto drawn = result_.luminance.begin() + begin;
        for (int y = 0; y < nodes.y; ++y)
            for (int x = 0; x < nodes.x; ++x) {
                const dvec3 m =
                    rgl_facet(warp.density().place({unit_place(x, nodes.x), unit_place(y, nodes.y)}));
                const dvec3 value = 4 * sigma * shape_.over_ndf(from, mirrored(wi, m), m);
                values[y * nodes.x + x] = glm::vec3(value);
                drawn[y * nodes.x + x] =
                    static_cast<float>(luminance(value) * shape_.ndf(m) * std::max(0.0, glm::dot(m, wi)) /
                                       warp.per_solid_angle(m));
            }
        const auto end = drawn + static_cast<std::ptrdiff_t>(nodes.x) * nodes.y;
        const float largest = *std::max_element(drawn, end);
        const float least = largest > 0 ? static_cast<float>(largest * least_luminance) : 1.0F;
        std::transform(drawn, end, drawn, [&](float value) { return std::max(value, least); });
        return warp.density();
    }

  private:
    template <class Of>
    void fill(glm::ivec2 nodes, std::vector<float>& table, const Of& of) const {
        for (int y = 0; y < nodes.y; ++y)
            for (int x = 0; x < nodes.x; ++x) {
                const double row = result_.isotropic() ? 0.5 : unit_place(y, nodes.y);
                table.push_back(static_cast<float>(of(rgl_facet({unit_place(x, nodes.x), row}))));
            }
    }

    const RglShape& shape_;
    RglTables& result_;
};

}  // namespace

std::size_t RglSize::incident() const { return static_cast<std::size_t>(azimuths * elevations); }

RglTables rgl_tables(const Tables& tables, const RglSize& size, const std::stop_token& stop) {
    const RglShape shape(tables);
    RglTables result;
    result.size = size;
    result.phi = azimuths(size.azimuths);
    for (int i = 0; i < size.elevations; ++i)
        result.theta.push_back(0.5 * pi * unit_place(i, size.elevations));
    result.values.resize(result.values_of(size.incident()));
    result.luminance.resize(result.values.size());
    const Maker maker(shape, result);
    maker.fill_normals();
    std::vector<std::optional<SquareDensity>> warps(size.incident());
    Workers(0, stop).for_each(static_cast<int>(warps.size()), [&](int i) {
        warps[static_cast<std::size_t>(i)] = maker.fill_incident(static_cast<std::size_t>(i));
    });
    for (auto& warp : warps) result.warp.push_back(*std::move(warp));
    return result;
}

}  // namespace nacre
