// Retro-reflection on the command line.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design leaning(double retro) {
    Design design = design_of(GgxLobe{0.3, 0.3}, 25, 40);
    design.diffuse = CoupledDiffuse{};
    design.retro.weight = retro;
    return design;
}

const std::string input = "0.5 0.1 0.8 0.6 -0.2 0.7\n-0.5 0.1 0.8 0.6 -0.2 0.7\n0.3 0.4 0.5 0.3 0.4 0.5\n";

}  // namespace

TEST_CASE("eval answers what goes back, from the tables and exactly") {
    const DesignOnDisk design(leaning(0.5)), plain(leaning(0));
    for (const char* term : {"retro", "specular", "total"}) {
        const auto baked = rows(answer({"eval", design.path(), "--term", term}, input));
        const auto exact = rows(answer({"eval", design.path(), "--exact", "--term", term}, input));
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                CHECK(exact[i].at(c) > 0);
                CHECK(std::fabs(baked[i].at(c) / exact[i].at(c) - 1) < 5e-3);
            }
    }
    CHECK(rows(answer({"eval", plain.path(), "--term", "retro"}, input))[0] == std::vector<double>{0, 0, 0});
    // The tables' own lines are those of p, whichever way light goes.
    CHECK(answer({"tables", design.path()}, "0.3 0.1 0.9\n") ==
          answer({"tables", plain.path()}, "0.3 0.1 0.9\n"));
}

TEST_CASE("info tells of retro-reflection where there is any") {
    const DesignOnDisk design(leaning(0.5)), plain(leaning(0));
    CHECK(answer({"info", design.path()}).find("retro-reflection, weight 0.5") != std::string::npos);
    CHECK(answer({"info", plain.path()}).find("retro") == std::string::npos);
    CHECK(answer({"info", design.path(), "--json"}).find("\"retro_weight\": 0.5") != std::string::npos);
}
