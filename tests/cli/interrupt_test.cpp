#include <doctest/doctest.h>
#include <signal.h>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"
#include "tests/cli/stopping.h"

using namespace nacre;
using namespace nacre::test;

TEST_CASE("Ctrl+C stops within a second whatever is going on") {
    Design velvet = slanted_velvet(true);
    velvet.shadowing.model = CorrelatedMasking{};
    const DesignOnDisk design(velvet);
    SUBCASE("exact integration") {
        check_stops_within_a_second({"tables", design.path(), "--exact"},
                                    {.input = lines_of(test_directions(5000)), .signal = SIGINT});
    }
    SUBCASE("the sweep of extreme designs") {
        check_stops_within_a_second({"check", "--extremes"}, {.signal = SIGINT, .signal_after = 2});
    }
    SUBCASE("drawing") {
        const TemporaryFolder folder;
        check_stops_within_a_second(
            {"render", design.path(), "-o", folder / "big.png", "--size", "4096x4096"},
            {.signal = SIGINT, .signal_after = 1});
        CHECK(folder.size() == 0);
    }
    SUBCASE("a folder of tables") {
        const TemporaryFolder folder;
        check_stops_within_a_second({"bake", design.path(), "-o", folder / "tables"},
                                    {.signal = SIGINT, .signal_after = 0.7});
        CHECK(folder.size() == 0);
    }
    SUBCASE("waiting for input") {
        const ChildOptions waiting{
            .input = "0 0 1 0 0 1\n", .input_stays_open = true, .signal = SIGTERM, .signal_after = 2};
        check_stops_within_a_second({"eval", design.path()}, waiting);
        CHECK(rows(run_cli({"eval", design.path()}, waiting).out).size() == 1);
    }
}
