#include <doctest/doctest.h>
#include <signal.h>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

void check_stopped(const Finished& finished) {
    CHECK(finished.code == 1);
    CHECK(finished.err == "nacre-cli: stopped\n");
    CHECK(finished.seconds_after_signal < 1);
}

}  // namespace

TEST_CASE("Ctrl+C stops within a second whatever is going on") {
    Design velvet = slanted_velvet(true);
    velvet.shadowing.model = ShadowingModel::correlated;
    const DesignOnDisk design(velvet);
    SUBCASE("exact integration") {
        check_stopped(run_cli({"tables", design.path(), "--exact"},
                              {.input = lines_of(test_directions(5000)), .signal = SIGINT}));
    }
    SUBCASE("the sweep of extreme designs") {
        check_stopped(run_cli({"check", "--extremes"}, {.signal = SIGINT, .signal_after = 2}));
    }
    SUBCASE("waiting for input") {
        const Finished finished = run_cli(
            {"eval", design.path()},
            {.input = "0 0 1 0 0 1\n", .input_stays_open = true, .signal = SIGTERM, .signal_after = 2});
        check_stopped(finished);
        CHECK(rows(finished.out).size() == 1);
    }
    SUBCASE("drawing") {
        const TemporaryFolder folder;
        check_stopped(run_cli({"render", design.path(), "-o", folder / "big.png", "--size", "4096x4096"},
                              {.signal = SIGINT, .signal_after = 1}));
        CHECK(folder.size() == 0);
    }
    SUBCASE("a folder of tables") {
        const TemporaryFolder folder;
        check_stopped(run_cli({"bake", design.path(), "-o", folder / "tables"},
                              {.signal = SIGINT, .signal_after = 0.7}));
        CHECK(folder.size() == 0);
    }
}
