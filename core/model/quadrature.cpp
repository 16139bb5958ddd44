#include "core/model/quadrature.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace nacre {

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

template const std::vector<QuadraturePoint>& gauss_legendre<7>();
template const std::vector<QuadraturePoint>& gauss_legendre<10>();
template const std::vector<QuadraturePoint>& gauss_legendre<14>();
template const std::vector<QuadraturePoint>& gauss_legendre<16>();
template const std::vector<QuadraturePoint>& gauss_legendre<20>();
template const std::vector<QuadraturePoint>& gauss_legendre<28>();
template const std::vector<QuadraturePoint>& gauss_legendre<30>();
template const std::vector<QuadraturePoint>& gauss_legendre<32>();
template const std::vector<QuadraturePoint>& gauss_legendre<40>();
template const std::vector<QuadraturePoint>& gauss_legendre<44>();
template const std::vector<QuadraturePoint>& gauss_legendre<60>();
template const std::vector<QuadraturePoint>& gauss_legendre<64>();

const GaussKronrod& gauss_kronrod() {
    using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    static const GaussKronrod rule = {Kronrod::abscissa(), Kronrod::weights(), Gauss::weights()};
    return rule;
}

}  // namespace nacre
