// Scripts that the designer plays for `screenshot`.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"

using namespace nacre;
using namespace nacre::test;

TEST_CASE("a script saves over the design that it began with, which nobody else has changed") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const std::string before = read_all(design.path()), script = folder / "save.events";
    std::ofstream(script) << "click \"Duplicate layer\"\nkey Ctrl+S\nframes 3\n";
    answer({"screenshot", design.path(), "-o", folder / "a.png", "--size", "1000x700", "--script", script});
    const std::string after = read_all(design.path());
    CHECK(after != before);
    CHECK(answer({"info", design.path()}).find("50") != std::string::npos);
}
