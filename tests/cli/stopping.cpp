#include "tests/cli/stopping.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

namespace nacre::test {

void check_stops_within_a_second(const std::vector<std::string>& arguments, const ChildOptions& options) {
    double quickest = std::numeric_limits<double>::infinity();
    for (int go = 0; go < 3 && quickest >= 1; ++go) {
        const Finished finished = run_cli(arguments, options);
        CHECK(finished.code == 1);
        CHECK(finished.err == "nacre-cli: stopped\n");
        quickest = std::min(quickest, finished.seconds_after_signal);
    }
    CHECK(quickest < 1);
}

}  // namespace nacre::test
