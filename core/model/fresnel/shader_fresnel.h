#pragma once

#include <functional>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace nacre {

// F as a table: node i of n at the cosine (i/(n - 1))^2, straight lines in the root of the cosine between
// nodes.
struct FresnelCurve {
    int nodes = 0;
    std::vector<float> values;  // red, green and blue of each node, 0 to 1
    double clipped = 0;         // how far the colours were outside 0 to 1, at most
    double error = 0;           // of straight lines between the nodes, at most, as measured
};

// What NAME_fresnel(a, b, cosine) of the shader reads.
struct ShaderFresnel {
    glm::dvec3 a{0};
    glm::dvec3 b{0};
    std::shared_ptr<const FresnelCurve> curve =
        nullptr;  // of a model that is a table; a is then left to describe it
};

// What in air reflects f0 straight on, as an index without absorption would, seen in a medium of index
// `above`:
// ((n - above)/(n + above))^2, n = (1 + sqrt f0)/(1 - sqrt f0).
inline glm::dvec3 reflectance_beneath(glm::dvec3 f0, double above) {
    if (above == 1) return f0;
    const glm::dvec3 root = glm::sqrt(f0),
                     q = ((1.0 + root) - above * (1.0 - root)) / ((1.0 + root) + above * (1.0 - root));
    return q * q;
}

// What the tables of R hold besides R with F = 1.
enum class FresnelTables {
    none,    // F = 1
    linear,  // R with Schlick's weight, in which R is linear: a is f0
    exact    // R with the design's own F, one table for each colour
};

// F of any model, each colour, at a cosine from 0 to 1.
using Reflectance = std::function<glm::dvec3(double cosine)>;

// The formula in manifests of a model that is a table; the table stands beside it.
inline constexpr const char* curve_formula =
    "F = fresnel_curve(sqrt(c)): straight lines between the rows of `fresnel_curve`, row i of n at i/(n-1), "
    "each colour";

}  // namespace nacre
