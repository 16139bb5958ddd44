// What a kind says of its parameters. A kind is a lobe, a Fresnel, a diffuse or a masking model: a plain
// struct in a header of its own, whose static parameters() is the only list of what it holds. Files, checks,
// fields of the window and random designs follow that list; a member that is not in it does not compile (see
// kind.h).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/range.h"
#include "core/image/raster.h"

namespace nacre {

// Key in the file, label and tooltip in the window.
struct ParameterText {
    std::string_view key;
    const char* label;
    const char* tooltip;
    // In the manifest of exported tables, where it has another name there.
    std::string_view key_in_tables = {};

    constexpr std::string_view table_key() const { return key_in_tables.empty() ? key : key_in_tables; }
};

// How a number is shown: the ends of its slider, which may be typed past up to the bounds.
struct SliderScale {
    Range ends;
    const char* format = "%.3f";
    bool logarithmic = false;
};

template <class Kind>
struct NumberParameter {
    double Kind::*member;
    ParameterText text;
    Range bounds;
    SliderScale slider;
    bool may_be_infinite = false;
};

// A colour, linear Rec. 709, picked by a swatch.
template <class Kind>
struct ColourParameter {
    glm::dvec3 Kind::*member;
    ParameterText text;
    Range bounds;
};

// A number each for red, green and blue that is no colour.
template <class Kind>
struct TripleParameter {
    glm::dvec3 Kind::*member;
    ParameterText text;
    Range bounds;
    SliderScale slider;
};

// One of an enum's values, which count from 0.
template <class Kind, class Enum, std::size_t count>
struct ChoiceParameter {
    Enum Kind::*member;
    ParameterText text;
    std::array<std::string_view, count> names;  // in the file
    std::array<const char*, count> labels;      // in the window
    glm::dvec3 (*swatch)(std::size_t) =
        nullptr;  // the colour of a choice, linear Rec. 709, where they have one
};

// Points (theta, value), theta in degrees and rising from point to point.
template <class Kind>
struct CurveParameter {
    std::vector<std::pair<double, double>> Kind::*member;
    ParameterText text;
    Range theta_bounds;
    Range value_bounds;
    int points_max;  // 2 at least
};

// A colour, linear Rec. 709, at an angle in degrees.
struct ColourPoint {
    double theta;
    glm::dvec3 colour;
    bool operator==(const ColourPoint&) const = default;
};

// Points whose theta rises from point to point.
template <class Kind>
struct ColourCurveParameter {
    std::vector<ColourPoint> Kind::*member;
    ParameterText text;
    Range theta_bounds;
    Range value_bounds;
    int points_max;  // 1 at least
};

// One of another set of kinds, a std::variant; in files its parameters stand beside its name.
template <class Kind, class Set>
struct KindParameter {
    Set Kind::*member;
    ParameterText text;
    const char* no_other;  // why no other kind will do, for a message
};

// A list of structs that have a name and parameters() as kinds do.
template <class Kind, class Row>
struct ListParameter {
    std::vector<Row> Kind::*member;
    ParameterText text;
    int rows_max;  // 0 at least
};

template <class Kind>
struct PictureParameter {
    Picture Kind::*member;
    ParameterText text;
};

}  // namespace nacre
