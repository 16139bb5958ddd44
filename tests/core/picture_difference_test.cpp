// Two pictures of four pixels, by hand.
#include "core/compare/picture_difference.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/image/srgb.h"

using namespace nacre;

namespace {

// RGBA; the last pixel does not count.
const std::vector<float> a = {1, 2, 3, 9, 0, 0, 0, 9, 1, 1, 1, 9, 7, 7, 7, 9};
const std::vector<float> b = {1, 2, 5, 0, 0, 0, 0, 0, 2, 1, 1, 0, 0, 0, 0, 0};

bool but_the_last(std::size_t pixel) { return pixel < 3; }

}  // namespace

TEST_SUITE_BEGIN("picture difference");

TEST_CASE("numbers: over the colours of the pixels that count") {
    const DifferenceNumbers apart = measure_difference(a, b, 4, but_the_last);
    CHECK(apart.pixels == 3);
    CHECK(apart.largest == 2);
    // Squares 4 and 1 over nine colours; half of 17 and 36 together is what both hold.
    CHECK(apart.root_mean_square == doctest::Approx(std::sqrt(5.0 / 9)));
    CHECK(apart.relative == doctest::Approx(std::sqrt(5 / 26.5)));
    const DifferenceNumbers none = measure_difference(a, b, 4, [](std::size_t) { return false; });
    CHECK(none.pixels == 0);
    CHECK(none.root_mean_square == 0);
    CHECK(none.relative == 0);
}

TEST_CASE("the picture of it: each colour's, or which side is brighter") {
    const std::vector<float> plain = difference_picture(a, b, 4, {.amplification = 0.25, .is_signed = false});
    REQUIRE(plain.size() == 12);
    CHECK(plain[0] == 0);
    CHECK(static_cast<double>(plain[2]) == doctest::Approx(srgb_encoded(0.5)));
    CHECK(plain[9] == 1);  // 7/4 stops at 1
    const std::vector<float> sign = difference_picture(a, b, 4, {.amplification = 1, .is_signed = true});
    CHECK(sign[6] > sign[8]);   // brighter in b: orange
    CHECK(sign[9] < sign[11]);  // darker: blue
    CHECK(sign[3] == 0);
}

TEST_CASE("the divider stands between two columns, also at either end") {
    const std::vector<float> left(12, 1.0f), right(12, 2.0f);  // 4 x 1 pixels of three
    for (int column = 0; column <= 4; ++column) {
        const std::vector<float> both = divided_picture(left, right, {4, 1}, 3, column / 4.0);
        for (int i = 0; i < 12; ++i)
            CHECK(both[static_cast<std::size_t>(i)] == (i < 3 * column ? 1.0f : 2.0f));
    }
}

TEST_SUITE_END();
