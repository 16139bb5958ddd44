#include "tests/gl/golden.h"

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/image/image_file.h"
#include "tests/gl/read_png.h"

namespace nacre::test {
namespace {

namespace fs = std::filesystem;

const fs::path references = fs::path(NACRE_SOURCE_DIR) / "tests/golden";
const fs::path failures = fs::path(NACRE_BINARY_DIR) / "golden";

// Of 255.
double difference(const std::vector<float>& actual, const std::vector<float>& expected, std::size_t i) {
    return 255 * std::fabs(static_cast<double>(actual[i]) - static_cast<double>(expected[i]));
}

// Eight times the difference.
std::vector<float> difference_of(const std::vector<float>& actual, const std::vector<float>& expected) {
    std::vector<float> picture;
    for (std::size_t i = 0; i < actual.size(); ++i)
        picture.push_back(static_cast<float>(std::fmin(8 * difference(actual, expected, i) / 255, 1)));
    return picture;
}

}  // namespace

std::string golden_fault(const GoldenRule& rule, const std::vector<float>& actual,
                         const std::vector<float>& expected) {
    double worst = 0, sum = 0;
    int unequal = 0;
    for (std::size_t i = 0; i < actual.size(); i += 3) {
        double of_pixel = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            const double d = difference(actual, expected, c);
            of_pixel = std::fmax(of_pixel, d);
            sum += d;
        }
        worst = std::fmax(worst, of_pixel);
        unequal += of_pixel > rule.noticed ? 1 : 0;
    }
    const double mean = sum / static_cast<double>(actual.size());
    if (worst <= rule.worst && mean <= rule.mean && unequal <= rule.pixels) return {};
    return fmt::format("off by {:.0f} at most, {:.2f} in the mean, {} pixels by more than {:g}", worst, mean,
                       unequal, rule.noticed);
}

void check_golden(const std::string& name, const GoldenRule& rule, glm::ivec2 size,
                  const std::vector<float>& rgb) {
    CAPTURE(name);
    const fs::path reference = references / (name + ".png");
    if (std::getenv("NACRE_UPDATE_GOLDEN")) {
        write_image(reference, size, rgb);
        return;
    }
    REQUIRE(fs::exists(reference));
    const std::vector<float> expected = read_png(reference, size);
    REQUIRE(expected.size() == rgb.size());
    const std::string fault = golden_fault(rule, rgb, expected);
    CHECK(fault == "");
    if (fault.empty()) return;
    fs::create_directories(failures);
    write_image(failures / (name + ".actual.png"), size, rgb);
    write_image(failures / (name + ".difference.png"), size, difference_of(rgb, expected));
    MESSAGE("see " << (failures / (name + ".actual.png")).string());
}

}  // namespace nacre::test
