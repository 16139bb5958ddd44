// Rules of integration. Boost.Math's tables of nodes stay in quadrature.cpp: most of the program sees this
// header.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nacre {

struct QuadraturePoint {
    double x;
    double weight;
};

// Gauss-Legendre with Points nodes on [0, 1]; quadrature.cpp lists the numbers of nodes there are.
template <unsigned Points>
const std::vector<QuadraturePoint>& gauss_legendre();

template <std::size_t Size>
using Values = std::array<double, Size>;

// The Gauss-Kronrod pair (7, 15) on [-1, 1]: its nodes x >= 0 from the middle out, of which every other one,
// the middle included, is Gauss's.
struct GaussKronrod {
    std::array<double, 8> x;
    std::array<double, 8> weight;
    std::array<double, 4> gauss_weight;
};

const GaussKronrod& gauss_kronrod();

// A map of [0, 1] onto itself, x = s^3 (10 - 15 s + 6 s^2), and its derivative as the weight: rules get close
// to both ends, and a power of 3/2 there becomes smooth.
inline QuadraturePoint toward_ends(double s) {
    return {s * s * s * (10 + s * (6 * s - 15)), 30 * s * s * (1 - s) * (1 - s)};
}

// Adaptive Gauss-Kronrod (7, 15) of a vector-valued f over [a, b]: halves an interval until the two rules
// agree within `tolerance` (absolute, halved with the interval, every component) or `depth` is used up.
template <std::size_t Size, class Function>
Values<Size> integrate_adaptively(const Function& f, double a, double b, double tolerance, int depth) {
    const GaussKronrod& rule = gauss_kronrod();
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    Values<Size> fine{}, coarse{};
    for (std::size_t i = 0; i < rule.x.size(); ++i) {
        Values<Size> sum = f(middle + half * rule.x[i]);
        if (i > 0) {
            const Values<Size> left = f(middle - half * rule.x[i]);
            for (std::size_t j = 0; j < Size; ++j) sum[j] += left[j];
        }
        for (std::size_t j = 0; j < Size; ++j) {
            fine[j] += half * rule.weight[i] * sum[j];
            if (i % 2 == 0) coarse[j] += half * rule.gauss_weight[i / 2] * sum[j];
        }
    }
    double error = 0;
    for (std::size_t j = 0; j < Size; ++j) error = std::fmax(error, std::fabs(fine[j] - coarse[j]));
    if (error <= tolerance || depth == 0) return fine;
    const Values<Size> left = integrate_adaptively<Size>(f, a, middle, 0.5 * tolerance, depth - 1);
    const Values<Size> right = integrate_adaptively<Size>(f, middle, b, 0.5 * tolerance, depth - 1);
    for (std::size_t j = 0; j < Size; ++j) fine[j] = left[j] + right[j];
    return fine;
}

}  // namespace nacre
