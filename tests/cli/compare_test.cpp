#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// "... root mean square X, ..."
double number_after(const std::string& text, const std::string& words) {
    return std::stod(text.substr(text.find(words) + words.size()));
}

}  // namespace

TEST_CASE("render --compare: a picture, and how far the two are apart") {
    const TemporaryFolder folder;
    Design design = design_of(GgxLobe{0.3, 0.3});
    const DesignOnDisk on_disk(design);
    const std::string picture = folder / "pair.png";
    const std::vector<std::string> render = {"render", on_disk.path(), "-o", picture, "--size", "64x64"};
    const auto compare = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = render;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return answer(arguments);
    };
    for (const char* model : {"ward", "ggx", "beckmann", "oren_nayar", "correlated", "smith_correlated"}) {
        CAPTURE(model);
        const std::string told = compare({"--compare", model});
        CHECK(number_after(told, "root mean square ") > 0);
        CHECK(std::filesystem::file_size(picture) > 1000);
        std::filesystem::remove(picture);
    }
    // The same masking again, or the same file, is the same surface.
    CHECK(number_after(compare({"--compare", "uncorrelated"}), "root mean square ") == 0);
    CHECK(number_after(compare({"--compare", on_disk.path(), "--view", "difference"}), "largest ") == 0);
}

TEST_CASE("render: a model has no factors, and says so") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const Finished finished =
        run_cli({"render", design.path(), "-o", "x.png", "--compare", "ward", "--term", "P1"});
    CHECK(finished.code == 1);
    CHECK_MESSAGE(is_one_line_with(finished.err, {"ward", "no factor P1"}), finished.err);
}

TEST_CASE("eval --term: the factors multiply to the specular term") {
    const DesignOnDisk design(design_of(GgxLobe{0.2, 0.4}));
    const std::string pair = "0.3 0.1 1 -0.2 0.3 1\n";
    const auto term = [&](const char* name) {
        return rows(answer({"eval", design.path(), "--term", name}, pair))[0][0];
    };
    // P1 P2 = N^2 c1 c2/(g1 g2)                                             (eq. 25)
    const double c1 = 1 / std::sqrt(1.1), c2 = 1 / std::sqrt(1.13);
    const double N = std::sqrt(term("P1") * term("P2") / (term("1/gg") * c1 * c2));
    CHECK(term("p") * term("F") * N / 4 * term("1/gg") == doctest::Approx(term("specular")).epsilon(1e-6));
}
