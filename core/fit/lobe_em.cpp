#include "core/fit/lobe_em.h"

#include <algorithm>
#include <cmath>

#include "core/fit/lobe_parameters.h"

namespace nacre {

namespace {

constexpr int rounds = 80;
constexpr std::size_t chunk = 256;   // facets of one task, whatever the threads
constexpr double facing_min = 0.05;  // of h.N: beyond it a facet is no part of a lobe
constexpr double part_min = 5;       // facets that a lobe needs for a shape of its own
constexpr double square_min = 1e-7;  // of a variance of slopes

// Slopes have the covariance S, which is alpha^2/2 of both shapes.
struct Cluster {
    LobeFrame frame;
    double s11 = 1, s12 = 0, s22 = 1;
};

struct Moments {
    double part = 0, weight = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void operator+=(const Moments& other) {
        part += other.part;
        weight += other.weight;
        x += other.x;
        y += other.y;
        xx += other.xx;
        xy += other.xy;
        yy += other.yy;
    }
};

double nearest_cosine(const std::vector<Cluster>& clusters, dvec3 h) {
    double best = -1;
    for (const Cluster& cluster : clusters) best = std::max(best, glm::dot(cluster.frame.N, h));
    return best;
}

dvec3 not_too_tilted(dvec3 N) {
    N = glm::normalize(N);
    const double slope = std::hypot(N.x, N.y) / std::max(N.z, 1e-9);
    return slope > slope_max ? glm::normalize(dvec3(N.x, N.y, std::hypot(N.x, N.y) / slope_max)) : N;
}

// Each new normal is a facet, the likelier the farther it is from those before (k-means++).
std::vector<Cluster> spread_normals(std::span<const dvec3> facets, int count, Random& random) {
    std::vector<Cluster> clusters;
    std::vector<double> distance(facets.size(), 1.0);
    for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (const double d : distance) sum += d;
        double left = uniform_random(random) * sum;
        std::size_t at = 0;
        while (at + 1 < facets.size() && left >= distance[at]) left -= distance[at++];
        Cluster cluster;
        turn_frame(cluster.frame, not_too_tilted(facets[at]));
        clusters.push_back(cluster);
        for (std::size_t j = 0; j < facets.size(); ++j)
            distance[j] = std::min(distance[j], std::max(1 - glm::dot(facets[j], cluster.frame.N), 1e-9));
    }
    return clusters;
}

std::vector<Cluster> first_clusters(std::span<const dvec3> facets, int count, bool tilted, Random& random) {
    std::vector<Cluster> clusters = tilted ? spread_normals(facets, count, random)
                                           : std::vector<Cluster>(static_cast<std::size_t>(count));
    std::vector<double> squares;
    for (const dvec3 h : facets) squares.push_back(2 * (1 - nearest_cosine(clusters, h)));
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    for (int i = 0; i < count; ++i) {
        Cluster& cluster = clusters[static_cast<std::size_t>(i)];
        cluster.frame.weight = 1.0 / count;
        // Lobes on one normal differ in width from the start.
        const double wider = tilted || count == 1 ? 1 : 0.5 * std::pow(5, i / (count - 1.0));
        cluster.s11 = cluster.s22 = std::max(*middle * wider * wider, 1e-6);
    }
    return clusters;
}

// Adds one facet to the moments of every cluster, as much as it is part of each.
void add_facet(const std::vector<Cluster>& clusters, LobeShape shape, dvec3 h, std::vector<double>& density,
               std::vector<Moments>& moments) {
    double sum = 1e-300;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const Cluster& c = clusters[i];
        const InFrame at = in_frame(c.frame, h);
        density[i] = 0;
        if (at.z < facing_min) continue;
        const double det = c.s11 * c.s22 - c.s12 * c.s12, x = at.x / at.z, y = at.y / at.z;
        const double q = (c.s22 * x * x - 2 * c.s12 * x * y + c.s11 * y * y) / (2 * det);
        density[i] = c.frame.weight / (std::sqrt(det) * at.z * at.z * at.z) * lobe_kernel(shape, q).value;
        sum += density[i];
    }
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const double part = density[i] / sum;
        if (part < 1e-12) continue;
        const Cluster& c = clusters[i];
        const InFrame at = in_frame(c.frame, h);
        const double det = c.s11 * c.s22 - c.s12 * c.s12, x = at.x / at.z, y = at.y / at.z;
        const double q = (c.s22 * x * x - 2 * c.s12 * x * y + c.s11 * y * y) / (2 * det);
        const double weight = shape == LobeShape::ggx ? part * 2 / (1 + q) : part;
        moments[i] += {part, weight, weight * x, weight * y, weight * x * x, weight * x * y, weight * y * y};
    }
}

void move(Cluster& cluster, const Moments& m, std::size_t facets, bool tilted) {
    cluster.frame.weight = m.part / static_cast<double>(facets) + 1e-9;
    if (m.part < part_min) return;
    const double x = tilted ? m.x / m.weight : 0, y = tilted ? m.y / m.weight : 0;
    cluster.s11 = std::max(m.xx - x * x * m.weight, 0.0) / m.part + square_min;
    cluster.s22 = std::max(m.yy - y * y * m.weight, 0.0) / m.part + square_min;
    cluster.s12 = (m.xy - x * y * m.weight) / m.part;
    const LobeFrame& f = cluster.frame;
    if (tilted) turn_frame(cluster.frame, not_too_tilted(f.N + x * f.X + y * f.Y));
}

}  // namespace

std::vector<LobeFrame> em_lobes(std::span<const dvec3> facets, LobeShape shape, int count, bool tilted,
                                std::uint64_t seed, Workers& workers) {
    Random random(seed);
    std::vector<Cluster> clusters = first_clusters(facets, count, tilted, random);
    const std::size_t tasks = (facets.size() + chunk - 1) / chunk;
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::vector<Moments>> parts(tasks, std::vector<Moments>(clusters.size()));
        workers.for_each(static_cast<int>(tasks), [&](int task) {
            const std::size_t begin = static_cast<std::size_t>(task) * chunk;
            std::vector<double> density(clusters.size());
            for (std::size_t j = begin; j < std::min(begin + chunk, facets.size()); ++j)
                add_facet(clusters, shape, facets[j], density, parts[static_cast<std::size_t>(task)]);
        });
        for (std::size_t task = 1; task < tasks; ++task)
            for (std::size_t i = 0; i < clusters.size(); ++i) parts[0][i] += parts[task][i];
        for (std::size_t i = 0; i < clusters.size(); ++i)
            move(clusters[i], parts[0][i], facets.size(), tilted);
    }
    std::vector<LobeFrame> lobes;
    for (Cluster& c : clusters) {
        const double det = 2 * (c.s11 * c.s22 - c.s12 * c.s12);  // A is the inverse of 2 S
        c.frame.a11 = c.s22 / det;
        c.frame.a22 = c.s11 / det;
        c.frame.a12 = -c.s12 / det;
        lobes.push_back(c.frame);
    }
    return lobes;
}

}  // namespace nacre
