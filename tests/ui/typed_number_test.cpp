// What is a number to a person, and what is none.
#include "ui/typed_number.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace nacre;

namespace {

constexpr ui::NumberRange wide{.least = -1e6, .most = 1e6};

double number(const char* text, const char* format = "%.3f") {
    const ui::TypedNumber typed = ui::typed_number(text, format, wide);
    CHECK_MESSAGE(typed.problem.empty(), text, ": ", typed.problem);
    return typed.value;
}

std::string problem(const std::string& text, const ui::NumberRange& range = wide) {
    return ui::typed_number(text, "%.3f", range).problem;
}

}  // namespace

TEST_CASE("typed number: a comma is a decimal point") {
    CHECK(number("0,5") == 0.5);
    CHECK(number("0.5") == 0.5);
    CHECK(number(",25") == 0.25);
    CHECK(number("-1,5e-3") == -0.0015);
    CHECK(number("+2") == 2);
    CHECK(number("7,") == 7);
    CHECK(number("\u22123") == -3);
    CHECK(number(" 1,234 ") == 1.234);
    CHECK(number("0,1") == 0.1);  // all its digits
    CHECK(number("1E3") == 1000);
}

TEST_CASE("typed number: what the field writes around it may stay") {
    CHECK(number("35\u00b0", "%.1f\u00b0") == 35);
    CHECK(number("r 3,5\u00b0", "r %.1f\u00b0") == 3.5);
    CHECK(number("hard 40 %", "hard %.0f %%") == 40);
    CHECK(number("40", "hard %.0f %%") == 40);
    CHECK(number("+1,5 EV", "%+.2f EV") == 1.5);
    CHECK(number("\u00d7 2", "\u00d7 %.3f") == 2);
}

TEST_CASE("typed number: everything else is refused and said") {
    for (const char* text :
         {"",     " ",     "nan",     "NaN",     "-nan",    "nan(1)", "inf",   "-inf",  "infinity",
          "0x10", "0x1p3", "1.234,5", "1,234.5", "1.234.5", "1,2,3",  "1 000", "1'000", "--1",
          "+-1",  "e5",    "1e",      "1e+",     ".",       ",",      "-",     "abc",   "1a",
          "1f",   "5 px",  "1/2",     "2*3",     "\u0663",  "1\n2",   "1e5e5"}) {
        CAPTURE(text);
        CHECK(!problem(text).empty());
        CHECK(problem(text).find("-1e+06 to 1e+06") != std::string::npos);
    }
    CHECK(problem("1.234,5").find("1.234,5") != std::string::npos);
}

TEST_CASE("typed number: the range is kept, and names its ends") {
    const ui::NumberRange share{.least = 0, .most = 1};
    for (const char* text : {"1,0001", "-0,1", "7", "1e999", "-1e999"}) {
        CAPTURE(text);
        CHECK(problem(text, share).find("Allowed: 0 to 1") != std::string::npos);
    }
    CHECK(problem("1", share).empty());
    CHECK(problem("0", share).empty());
    const ui::NumberRange rays{.least = 3, .most = 24, .whole = true};
    CHECK(problem("4,5", rays).find("whole") != std::string::npos);
    CHECK(problem("4,0", rays).empty());
}

TEST_CASE("typed number: infinity where it has a place") {
    const ui::NumberRange width{.least = 1e-5, .most = 1e5, .infinite = true};
    for (const char* text : {"infinity", "Infinity", "inf", "\u221e", "infinite"})
        CHECK(std::isinf(ui::typed_number(text, "%.4g", width).value));
    for (const char* text : {"-infinity", "-inf", "nan", "1e999"}) {
        CAPTURE(text);
        CHECK(problem(text, width).find("or infinity") != std::string::npos);
    }
}
