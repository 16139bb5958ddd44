#include "core/study/oren_nayar_fit.h"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "core/model/lobe_model.h"

namespace nacre {

OrenNayar::OrenNayar(double sigma) {
    form_.model = Shading<double>::MODEL_OREN_NAYAR;
    form_.sigma2 = sigma * sigma;
}

double OrenNayar::of_albedo(double albedo, glm::dvec3 k1, glm::dvec3 k2) const {
    Shading<double>::ClosedForm form = form_;
    form.rho = glm::dvec3{albedo};
    return Shading<double>::oren_nayar(form, k1, k2).x;
}

double apart(const RoundBrdf& a, const RoundBrdf& b) {
    Random random(8);
    double sum = 0;
    constexpr int pairs = 2000;
    for (int i = 0; i < pairs; ++i) {
        const dvec3 k1 = cosine_sample(random), k2 = cosine_sample(random);
        const double off = a(k1, k2) - b(k1, k2);
        sum += off * off;
    }
    return std::numbers::pi * std::sqrt(sum / pairs);
}

double closest_sigma(const RoundBrdf& first_bounce) {
    const auto distance = [&](double sigma) {
        const OrenNayar theirs(sigma);
        return apart(first_bounce, [&](dvec3 k1, dvec3 k2) { return theirs.once(k1, k2); });
    };
    constexpr int bits = 16;
    return boost::math::tools::brent_find_minima(distance, 0.01, 1.2, bits).first;
}

}  // namespace nacre
