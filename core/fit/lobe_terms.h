// One lobe as Cycles evaluates it, and what its derivatives are made of.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nacre {

enum class LobeShape { beckmann, ggx };

// A lobe about its own normal N. The widths are held as the precision matrix A of slopes in the frame X, Y:
// a slope s of a facet counts as s.As, which is |s/alpha|^2 where A is diagonal.
struct LobeFrame {
    double weight = 1;
    glm::dvec3 N{0, 0, 1}, X{1, 0, 0}, Y{0, 1, 0};
    double a11 = 1, a12 = 0, a22 = 1;

    double determinant() const { return a11 * a22 - a12 * a12; }
};

// Y = N x T made of length 1 and X = Y x N, T being the x axis; N.z > 0.
void turn_frame(LobeFrame& lobe, glm::dvec3 N);

// Smith's Lambda as a function of s = |alpha-weighted slope of a direction|^2.
struct Lambda {
    double value;
    double slope;  // d value/d s
};
Lambda lobe_lambda(LobeShape shape, double s);

// The normal distribution is kernel * sqrt(det A)/(pi (N.h)^4), and q = s.As of the half vector's slope.
struct Kernel {
    double value;
    double log_slope;  // d log value/d q
};
Kernel lobe_kernel(LobeShape shape, double q);

// A direction in the frame of a lobe.
struct InFrame {
    double x, y, z;
};
InFrame in_frame(const LobeFrame& lobe, glm::dvec3 k);

struct LobeTerms {
    InFrame v, l, h;
    double q;
    Kernel kernel;
    double s_v, s_l;  // what the Lambdas are of
    Lambda lambda_v, lambda_l;
    double bare;  // D/(4 (1 + Lambda(v) + Lambda(l)) (n.l)), which 1/(N.v) and the weight make the BRDF
};

// False where the lobe sends no light from l into v, all above the horizon, h being the half vector.
bool lobe_terms(LobeShape shape, const LobeFrame& lobe, glm::dvec3 v, glm::dvec3 l, glm::dvec3 h,
                LobeTerms& terms);

}  // namespace nacre
