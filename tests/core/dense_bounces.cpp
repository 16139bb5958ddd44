#include "tests/core/dense_bounces.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace nacre::test {
namespace {

using std::numbers::pi;
using Matrix = std::vector<double>;

// Evenly over the upper hemisphere, then their opposites.
std::vector<dvec3> travel_directions(int count) {
    std::vector<dvec3> all;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (i + 0.5) / count, s = std::sqrt(1 - z * z),
                     phi = 2 * pi * std::fmod(i * std::numbers::phi, 1.0);
        all.push_back({s * std::cos(phi), s * std::sin(phi), z});
    }
    for (int i = 0; i < count; ++i) all.push_back(-all[static_cast<std::size_t>(i)]);
    return all;
}

// X of (1 - A D) X = A, D diagonal.
Matrix solved(const Matrix& a, const std::vector<double>& d) {
    const std::size_t n = d.size();
    Matrix left(n * n), x = a;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) left[i * n + j] = (i == j ? 1 : 0) - a[i * n + j] * d[j];
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t i = column; i < n; ++i)
            if (std::fabs(left[i * n + column]) > std::fabs(left[pivot * n + column])) pivot = i;
        for (std::size_t j = 0; j < n; ++j) {
            std::swap(left[column * n + j], left[pivot * n + j]);
            std::swap(x[column * n + j], x[pivot * n + j]);
        }
        for (std::size_t i = column + 1; i < n; ++i) {
            const double factor = left[i * n + column] / left[column * n + column];
            if (factor == 0) continue;
            for (std::size_t j = column; j < n; ++j) left[i * n + j] -= factor * left[column * n + j];
            for (std::size_t j = 0; j < n; ++j) x[i * n + j] -= factor * x[column * n + j];
        }
    }
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t j = 0; j < n; ++j) {
            double sum = x[i * n + j];
            for (std::size_t l = i + 1; l < n; ++l) sum -= left[i * n + l] * x[l * n + j];
            x[i * n + j] = sum / left[i * n + i];
        }
    return x;
}

}  // namespace

// From travel along i to travel along j facets send p(h)/4, which is balanced so that each direction loses
// what g says.
DenseBounces dense_bounces(const FacetDistribution& distribution, int directions) {
    const std::vector<dvec3> d = travel_directions(directions);
    const std::size_t half = static_cast<std::size_t>(directions), n = d.size();
    const double dw = 2 * pi / directions;
    const auto reverse = [&](std::size_t i) { return i < half ? i + half : i - half; };
    Matrix a(n * n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (i != j && glm::length(d[j] - d[i]) > 1e-9)
                a[i * n + j] = distribution.density(glm::normalize(d[j] - d[i])) / 4;
    std::vector<double> g(n), scale(n, 1.0);
    for (std::size_t i = 0; i < n; ++i) g[i] = distribution.projected_area(-d[i]);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> next(n, 1.0);
        for (std::size_t i = 0; i < n; ++i) {
            double row = 0;
            for (std::size_t j = 0; j < n; ++j) row += a[i * n + j] * scale[j] * dw;
            row *= scale[reverse(i)];
            next[reverse(i)] = scale[reverse(i)] * (row > 0 ? std::sqrt(g[i] / row) : 1);
        }
        scale = next;
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) a[i * n + j] *= scale[j] * scale[reverse(i)];
    std::vector<double> ends(n);
    for (std::size_t i = 0; i < n; ++i) ends[i] = dw / distribution.projected_area(i < half ? d[i] : -d[i]);
    const Matrix x = solved(a, ends);
    DenseBounces result;
    const double N = distribution.mean_cosine();
    for (std::size_t i = 0; i < half; ++i) {
        result.k.push_back(d[i]);
        result.weight.push_back(d[i].z * dw);
        for (std::size_t j = 0; j < half; ++j) {
            const double gg = distribution.projected_area(d[i]) * distribution.projected_area(d[j]);
            result.first.push_back(N * a[(i + half) * n + j] / gg);
            result.all.push_back(N * x[(i + half) * n + j] / gg);
        }
    }
    return result;
}

}  // namespace nacre::test
