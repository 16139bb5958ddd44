#include <doctest/doctest.h>

#include <boost/math/special_functions/expint.hpp>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;
using Visibility = std::function<double(glm::dvec3)>;

// docs/mathematics.md, sec. 7; p normalised so that N = 1.
double ggx_visibility(glm::dvec3 k, glm::dvec2 alpha) {
    const double r = std::sqrt(std::pow(alpha.x * k.x, 2) + std::pow(alpha.y * k.y, 2) + k.z * k.z);
    return 2 * k.z / (k.z + r);
}

double beckmann_visibility(glm::dvec3 k, glm::dvec2 alpha) {
    const double q = std::hypot(alpha.x * k.x, alpha.y * k.y), v = k.z / q;
    return k.z / (0.5 * k.z * (1 + std::erf(v)) + q * std::exp(-v * v) / (2 * std::sqrt(pi)));
}

double worst_error(const std::string& output, const std::vector<glm::dvec3>& directions,
                   const Visibility& exact) {
    const auto answers = rows(output);
    REQUIRE(answers.size() == directions.size());
    double worst = 0;
    for (std::size_t i = 0; i < directions.size(); ++i)
        worst = std::fmax(worst, std::fabs(answers[i].at(1) / exact(directions[i]) - 1));
    return worst;
}

void check_visibility(const Lobe& lobe, const Visibility& exact) {
    const DesignOnDisk design(design_of(lobe));
    const auto directions = test_directions(200);
    CHECK(worst_error(answer({"tables", design.path()}, lines_of(directions)), directions, exact) < 1e-3);
    const std::vector<glm::dvec3> few(directions.begin(), directions.begin() + 8);
    CHECK(worst_error(answer({"tables", design.path(), "--exact"}, lines_of(few)), few, exact) < 1e-8);
}

double erfcx(double x) { return std::exp(x * x) * std::erfc(x); }

// Mass, N and g at grazing of eq. 34 and eq. 35, not normalised; s >= 0.2, where the plain forms keep ten
// digits.
struct Moments {
    double mass, mean_cosine, grazing;
};

Moments gaussian_moments(double s) {
    const double a = 1 / (s * s);
    return {2 * pi * (1 - std::sqrt(pi * a) * erfcx(std::sqrt(a))),
            pi * (1 - a * std::exp(a) * boost::math::expint(1, a)),
            (1 + 2 * a) * (pi / 2) * erfcx(std::sqrt(a)) - std::sqrt(pi * a)};
}

Moments inverse_gaussian_moments(double s) {
    const double a = 1 / (s * s);
    return {pi * a * std::exp(a / 2) * (std::cyl_bessel_k(1, a / 2) - std::cyl_bessel_k(0, a / 2)),
            pi * (1 - a * std::exp(a) * boost::math::expint(1, a)),
            (1 - 2 * a) * (pi / 2) * erfcx(std::sqrt(a)) + std::sqrt(pi * a)};
}

void check_moments(const Lobe& lobe, const Moments& exact) {
    const DesignOnDisk design(design_of(lobe));
    const auto info = nlohmann::json::parse(answer({"info", design.path(), "--json"}));
    CHECK(info.at("N").get<double>() == doctest::Approx(exact.mean_cosine / exact.mass).epsilon(1e-8));
    const auto grazing = rows(answer({"tables", design.path(), "--exact"}, "1 0 0\n"));
    CHECK(grazing.at(0).at(0) == doctest::Approx(exact.grazing / exact.mass).epsilon(1e-8));
}

}  // namespace

TEST_CASE("P of GGX is its closed form, at every width down to grazing") {
    for (const glm::dvec2 alpha : {glm::dvec2{1e-3, 1e-3}, {0.1, 0.1}, {0.1, 1.0}, {1e-3, 10}, {10, 10}})
        check_visibility(GgxLobe{alpha.x, alpha.y}, [=](glm::dvec3 k) { return ggx_visibility(k, alpha); });
}

TEST_CASE("P of Beckmann is its closed form, at every width down to grazing") {
    for (const glm::dvec2 alpha : {glm::dvec2{1e-3, 1e-3}, {0.3, 0.3}, {0.02, 0.5}, {10, 1e-3}, {10, 10}})
        check_visibility(BeckmannLobe{alpha.x, alpha.y},
                         [=](glm::dvec3 k) { return beckmann_visibility(k, alpha); });
}

TEST_CASE("the uniform hemisphere: P and R are their closed forms") {
    const DesignOnDisk design(design_of(UniformLobe{}));
    const auto directions = test_directions(100);
    check_visibility(UniformLobe{}, [](glm::dvec3 k) { return 2 * k.z / (1 + k.z); });
    const auto answers = rows(answer({"tables", design.path()}, lines_of(directions)));
    const auto exact = rows(
        answer({"tables", design.path(), "--exact"}, lines_of({directions.begin(), directions.begin() + 4})));
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double albedo = 2 * (1 - std::numbers::ln2) / (1 + directions[i].z);
        CHECK(std::fabs(answers.at(i).at(3) - albedo) < 2e-3);
        if (i < exact.size()) CHECK(std::fabs(exact.at(i).at(3) - albedo) < 1e-6);
    }
}

TEST_CASE("N and g at grazing of the paper's lobes are their closed forms") {
    for (const double s : {0.2, 1.0, 10.0}) {
        check_moments(GaussianLobe{s, s}, gaussian_moments(s));
        check_moments(InverseGaussianLobe{s}, inverse_gaussian_moments(s));
    }
}

TEST_CASE("below the horizon g is exact and the rest is 0") {
    const DesignOnDisk design(design_of(UniformLobe{}));
    const auto answers = rows(answer({"tables", design.path()}, "0.6 0 -0.8\n0 0 -1\n"));
    CHECK(answers.at(0).at(0) == doctest::Approx(0.25 * (1 - 0.8)).epsilon(1e-8));
    CHECK(answers.at(0).at(1) == 0);
    CHECK(answers.at(0).at(3) == 0);
    CHECK(std::fabs(answers.at(1).at(0)) < 1e-12);
}
