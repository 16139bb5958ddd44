#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

// The integral of rho c over the hemisphere, midpoints of theta and phi.
double integrated_albedo(const std::string& design, glm::dvec3 k1) {
    constexpr int polar = 160, azimuths = 240;
    std::string input;
    std::vector<double> weights;
    for (int i = 0; i < polar; ++i) {
        const double theta = 0.5 * pi * (i + 0.5) / polar;
        for (int j = 0; j < azimuths; ++j) {
            input +=
                line_of(k1) + " " + line_of(at_height(std::cos(theta), 2 * pi * (j + 0.5) / azimuths)) + "\n";
            weights.push_back(std::cos(theta) * std::sin(theta) * (0.5 * pi / polar) * (2 * pi / azimuths));
        }
    }
    const auto values = rows(answer({"eval", design, "--term", "specular"}, input));
    REQUIRE(values.size() == weights.size());
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * values[i].at(0);
    return sum;
}

int violations(const nlohmann::json& report) {
    for (const auto& check : report.at("checks"))
        if (check.at("name") == "albedo") {
            const std::string text = check.at("text");
            return std::stoi(text.substr(text.find(" in ") + 4));
        }
    return -1;
}

}  // namespace

TEST_CASE("the albedo integrated from eval is R1, and never above 1 under clamp") {
    const DesignOnDisk slanted(slanted_velvet(true));
    for (const glm::dvec3 k : {at_height(0.9, 0.3), at_height(0.4, 3.0), at_height(0.1, 2.8)}) {
        const double table = rows(answer({"tables", slanted.path()}, line_of(k) + "\n")).at(0).at(3);
        const double integral = integrated_albedo(slanted.path(), k);
        CHECK(std::fabs(integral - table) < 3e-3);
        CHECK(integral <= 1);
    }
    for (const auto& row : rows(answer({"tables", slanted.path()}, lines_of(test_directions(2000)))))
        CHECK(row.at(3) <= 1);
}

TEST_CASE("without clamp the paper's slanted velvet creates energy, and check says so") {
    const DesignOnDisk slanted(slanted_velvet(false));
    double largest = 0;
    for (const auto& row : rows(answer({"tables", slanted.path()}, lines_of(test_directions(2000)))))
        largest = std::fmax(largest, row.at(3));
    CHECK(largest > 1.5);
    const Finished finished = run_cli({"check", slanted.path(), "--json"});
    CHECK(finished.code == 1);
    const auto report = nlohmann::json::parse(finished.out);
    CHECK(report.at("passed") == false);
    CHECK(violations(report) > 5);
    CHECK(violations(report) < 100);
}

TEST_CASE("check passes a height field, in text and in JSON") {
    Design model = design_of(GgxLobe{0.2, 0.4});
    model.fresnel = SchlickFresnel{};
    const DesignOnDisk design(model);
    const auto report = nlohmann::json::parse(answer({"check", design.path(), "--json"}));
    CHECK(report.at("passed") == true);
    CHECK(report.at("checks").size() == 12);
    CHECK(violations(report) == 0);
    CHECK(answer({"check", design.path()}).find("all checks pass") != std::string::npos);
}

TEST_CASE("check tells apart tables that are not what was wanted from tables that are not what was claimed") {
    Design grooves = design_of(GaussianLobe{0.002, 0.002});
    grooves.distribution.layers.push_back(grooves.distribution.layers[0]);
    grooves.distribution.layers[0].tilt = grooves.distribution.layers[1].tilt = 20;
    grooves.distribution.layers[1].azimuth = 180;
    const DesignOnDisk design(grooves);
    const auto report = nlohmann::json::parse(answer({"check", design.path(), "--json"}));
    CHECK(report.at("passed") == true);
    for (const auto& check : report.at("checks")) {
        const std::string name = check.at("name");
        const double figure = check.at("figure"), bound = check.at("bound");
        CAPTURE(name);
        if (name == "tolerance of R") {
            CHECK(check.at("verdict") == "note");
            CHECK(figure > bound);
            CHECK(bound == 1e-3);
        }
        if (name == "tables of R") {
            CHECK(check.at("verdict") == "pass");
            CHECK(figure <= bound);
            CHECK(bound > 1e-3);
            CHECK(bound < 5e-3);
        }
    }
}
