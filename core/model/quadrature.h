// Rules of integration.
#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <vector>

namespace nacre {

struct QuadraturePoint {
    double x;
    double weight;
};

// Gauss-Legendre with Points nodes on [0, 1].
template <unsigned Points>
const std::vector<QuadraturePoint>& gauss_legendre() {
    static const std::vector<QuadraturePoint> rule = [] {
        using Gauss = boost::math::quadrature::gauss<double, Points>;
        std::vector<QuadraturePoint> points;
        for (std::size_t i = Gauss::abscissa().size(); i-- > 0;)
            points.push_back({0.5 - 0.5 * Gauss::abscissa()[i], 0.5 * Gauss::weights()[i]});
        for (std::size_t i = Points % 2; i < Gauss::abscissa().size(); ++i)
            points.push_back({0.5 + 0.5 * Gauss::abscissa()[i], 0.5 * Gauss::weights()[i]});
        return points;
    }();
    return rule;
}

template <std::size_t Size>
using Values = std::array<double, Size>;

// Adaptive Gauss-Kronrod (7, 15) of a vector-valued f over [a, b]: halves an interval until the two rules
// agree within `tolerance` (absolute, halved with the interval, every component) or `depth` is used up.
template <std::size_t Size, class Function>
Values<Size> integrate_adaptively(const Function& f, double a, double b, double tolerance, int depth) {
    using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    Values<Size> fine{}, coarse{};
    const auto& x = Kronrod::abscissa();
    for (std::size_t i = 0; i < x.size(); ++i) {
        Values<Size> sum = f(middle + half * x[i]);
        if (i > 0) {
            const Values<Size> left = f(middle - half * x[i]);
            for (std::size_t j = 0; j < Size; ++j) sum[j] += left[j];
        }
        for (std::size_t j = 0; j < Size; ++j) {
            fine[j] += half * Kronrod::weights()[i] * sum[j];
            if (i % 2 == 0) coarse[j] += half * Gauss::weights()[i / 2] * sum[j];
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
