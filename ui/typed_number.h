// Numbers as people type and paste them.
#pragma once

#include <string>
#include <string_view>

namespace nacre::ui {

struct NumberRange {
    double least;
    double most;
    bool whole = false;     // no fractions
    bool infinite = false;  // "infinity" is one too
};

struct TypedNumber {
    double value = 0;
    std::string problem;  // in one line, what was found and what is allowed; empty where there is none
};

// Digits with a point or a comma before the fraction, and an exponent if need be. What `format` (of printf)
// writes around a number may stand around it here. Neither NaN nor hexadecimal digits, nor points or commas
// that group digits, are taken for something else.
TypedNumber typed_number(std::string_view text, const char* format, const NumberRange& range);

// A number as one would type it, in at most six digits.
std::string plain_number(double value);

}  // namespace nacre::ui
