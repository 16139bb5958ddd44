#include "core/study/spherical_harmonics.h"

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

bool kept(int degree) { return degree < 2 || degree % 2 == 0; }

}  // namespace

// The fully normalised recurrence in l at a fixed order m, without the sign (-1)^m of Condon and Shortley:
//   P(m,m) = sqrt((2m+1)/(2m)) sin P(m-1,m-1),  a^2 = (4 l^2 - 1)/(l^2 - m^2),  b^2 = a(l)^2/a(l-1)^2
HarmonicBasis::HarmonicBasis(int degree, bool round) : degree_(degree), orders_(round ? 0 : degree) {
    for (int m = 0; m <= orders_; ++m) {
        diagonal_.push_back(m == 0 ? std::sqrt(0.25 / pi) : std::sqrt((2 * m + 1) / (2.0 * m)));
        double previous = 0;
        for (int l = m; l <= degree; ++l) {
            const double l2 = static_cast<double>(l) * l, m2 = static_cast<double>(m) * m;
            const double a = l > m ? std::sqrt((4 * l2 - 1) / (l2 - m2)) : 0;
            steps_.push_back(
                {a, previous > 0 ? a / previous : 0, kept(l) ? static_cast<int>(degrees_.size()) : -1});
            previous = a;
            if (!kept(l)) continue;
            degrees_.push_back(l);
            if (m > 0) degrees_.push_back(l);
        }
    }
}

void HarmonicBasis::evaluate(dvec3 h, std::vector<double>& values) const {
    const Step* step = steps_.data();
    double diagonal = 1;
    double cosine = 1, sine = 0;  // sin^m(theta) times cos(m phi) and sin(m phi)
    for (int m = 0; m <= orders_; ++m) {
        diagonal *= diagonal_[static_cast<std::size_t>(m)];
        const double scale = m == 0 ? 1 : std::numbers::sqrt2;
        double value = diagonal, before = 0;
        for (int l = m; l <= degree_; ++l, ++step) {
            if (l > m) {
                const double next = step->a * h.z * value - step->b * before;
                before = value;
                value = next;
            }
            if (step->stored < 0) continue;
            const auto at = static_cast<std::size_t>(step->stored);
            values[at] = scale * value * cosine;
            if (m > 0) values[at + 1] = scale * value * sine;
        }
        const double turned = h.x * cosine - h.y * sine;
        sine = h.x * sine + h.y * cosine;
        cosine = turned;
    }
}

double clamped_cosine_factor(int degree) {
    if (degree == 1) return 2 * pi / 3;
    if (degree % 2 != 0) return 0;
    // l!/(2^l ((l/2)!)^2) = product of (2 i - 1)/(2 i)
    double central = 1;
    for (int i = 1; i <= degree / 2; ++i) central *= (2 * i - 1) / (2.0 * i);
    const double sign = degree % 4 == 0 ? -1 : 1;
    return 2 * pi * sign * central / ((degree + 2.0) * (degree - 1.0));
}

}  // namespace nacre
