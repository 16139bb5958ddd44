// The pressure of a pen, and the pace of a mouse in its place.
#include <doctest/doctest.h>

#include <limits>
#include <numeric>

#include "app/designer/pressure_axis.h"
#include "tests/designer/rig.h"

using namespace nacre;

namespace {

// What a drag over the canvas paints, in all.
double painted_by(std::optional<double> pressure, Follows radius, Follows flow, const char* frames = "40") {
    test::Rig r;
    r.canvas().brush = {
        .radius = 6, .hardness = 0.9, .flow = 1, .radius_follows = radius, .flow_follows = flow};
    r.canvas().pressure = pressure;
    r.play(std::string("click \"Paint\"\ndrag \"Canvas\":0.4,0.5 \"Canvas\":0.6,0.5 ") + frames);
    REQUIRE(r.layers().size() == 2);
    const std::vector<float>& values = std::get<PaintedLobe>(r.layers()[1].lobe).image.raster->values;
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("pen: its pressure is that of its axis, among those that an event tells") {
    const PressureAxis axis{2, 0, 2047};
    const unsigned char all = 0b111, without_x = 0b110, none = 0b011;
    const double values[] = {100, 200, 1023.5};
    CHECK(pressure_of(axis, {&all, 1}, values) == doctest::Approx(0.5));
    CHECK(pressure_of(axis, {&without_x, 1}, values + 1) == doctest::Approx(0.5));
    CHECK(!pressure_of(axis, {&none, 1}, values));
    const unsigned char far[] = {0, 0b10};
    CHECK(pressure_of({9, -1, 1}, far, values + 2) == 1);
    CHECK(!pressure_of({17, 0, 1}, far, values));
    const double wrong[] = {std::numeric_limits<double>::quiet_NaN()};
    const unsigned char first = 1;
    CHECK(!pressure_of({0, 0, 1}, {&first, 1}, wrong));
    CHECK(!pressure_of({0, 1, 1}, {&first, 1}, values));
}

TEST_CASE("pen: a light hand paints less where flow or size follow it, and a mouse paints in full") {
    const auto nothing = Follows::nothing, pressure = Follows::pressure;
    const double full = painted_by({}, nothing, nothing);
    CHECK(painted_by(0.2, nothing, nothing) == full);
    CHECK(painted_by({}, pressure, pressure) == full);
    CHECK(painted_by(1, pressure, pressure) == full);
    const double thin = painted_by(0.2, pressure, nothing), weak = painted_by(0.05, nothing, pressure);
    CHECK(thin > 0);
    CHECK(thin < 0.5 * full);
    CHECK(weak > 0);
    CHECK(weak < 0.8 * full);
}

TEST_CASE("pen: a slow hand paints more where the brush follows speed") {
    const double slow = painted_by({}, Follows::speed, Follows::nothing, "120"),
                 quick = painted_by({}, Follows::speed, Follows::nothing, "4");
    CHECK(quick < 0.8 * slow);
    CHECK(painted_by({}, Follows::nothing, Follows::nothing, "4") ==
          doctest::Approx(painted_by({}, Follows::nothing, Follows::nothing, "120")).epsilon(0.02));
}
