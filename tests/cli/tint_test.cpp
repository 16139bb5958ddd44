#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"
#include "tests/core/tinted_designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "tables prints R of each colour where tints differ, and with --exact the same to the bake's error") {
    const DesignOnDisk design(velvet());
    const std::string input = lines_of({at_height(0.8, 0.3), at_height(0.3, 2.9)});
    const auto baked = rows(answer({"tables", design.path()}, input));
    const auto exact = rows(answer({"tables", design.path(), "--exact"}, input));
    REQUIRE(baked.size() == 2);
    for (std::size_t i = 0; i < baked.size(); ++i) {
        REQUIRE(baked[i].size() == 8);
        REQUIRE(exact[i].size() == 8);
        for (std::size_t c = 2; c < 8; ++c) CHECK(std::fabs(baked[i][c] - exact[i][c]) < 1.5e-3);
        for (std::size_t c = 2; c < 5; ++c) CHECK(baked[i][c] < baked[i][c + 3]);
    }
    // Toward either side its own layer is seen most.
    CHECK(baked[0][5] > baked[0][7]);
    CHECK(baked[1][7] > baked[1][5]);
    const DesignOnDisk shared(velvet_of(crimson, crimson)), plain(velvet_of(glm::dvec3(1), glm::dvec3(1)));
    CHECK(answer({"tables", shared.path()}, input) == answer({"tables", plain.path()}, input));
}

TEST_CASE(
    "eval answers the same from the tables and exactly where layers have tints and the term an intensity") {
    Design model = velvet();
    model.diffuse = CoupledDiffuse{};
    model.specular.intensity = 2;
    const DesignOnDisk design(model);
    const std::string input = "0.5 0.1 0.8 0.6 -0.2 0.7\n-0.5 0.1 0.8 -0.6 -0.2 0.7\n";
    const auto baked = rows(answer({"eval", design.path()}, input));
    const auto exact = rows(answer({"eval", design.path(), "--exact"}, input));
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::fabs(baked[i].at(c) / exact[i].at(c) - 1) < 5e-3);
    CHECK(baked[0][0] > baked[0][2]);
    CHECK(baked[1][2] > baked[1][0]);
}

TEST_CASE("info tells of tints and of an intensity that creates energy") {
    Design model = velvet();
    model.specular.intensity = 2;
    const DesignOnDisk design(model);
    const std::string text = answer({"info", design.path()});
    CHECK(has(text, "gaussian, tint 0.7 0.02 0.08"));
    CHECK(has(text, "a tint of each layer"));
    CHECK(has(text, "intensity 2  specular intensity 2 creates energy"));
    const auto json = nlohmann::json::parse(answer({"info", design.path(), "--json"}));
    CHECK(json.at("specular_intensity") == 2);
    CHECK(json.at("creates_energy") == true);
    CHECK(json.at("layers").at(1).at("tint") == nlohmann::json({0.03, 0.04, 0.3}));
    const DesignOnDisk plain(Design{});
    CHECK_FALSE(has(answer({"info", plain.path()}), "tint"));
    CHECK_FALSE(has(answer({"info", plain.path()}), "intensity"));
}
