// The brush: round on the hemisphere, so that it is an ellipse on the disk toward the rim.
#pragma once

#include "core/base/choice.h"
#include "core/model/lobe.h"

namespace nacre {

// How paint combines with what is there.
enum class Blend { replace, add, multiply, maximum };

// In the order of the enumeration.
inline constexpr Choice blends[] = {
    {"replace", "Replace", "Paint goes toward the brush's value, up or down."},
    {"add", "Add", "Paint is added to what is there, up to full."},
    {"multiply", "Multiply", "What is there is multiplied by the brush's value: it darkens."},
    {"maximum", "Maximum", "Paint only lightens what is below the brush's value."}};

// What of the hand the size or the flow of a brush follows.
enum class Follows { nothing, pressure, speed };

// In the order of the enumeration.
inline constexpr Choice follows_kinds[] = {
    {"nothing", "Nothing", "The same all along the stroke."},
    {"pressure", "Pen pressure", "More where the pen presses harder; a mouse presses in full."},
    {"speed", "Speed", "More where the hand is slow, as ink does."}};

struct Brush {
    double radius = 8;      // degrees on the sphere of normals
    double hardness = 0.5;  // part of the radius that is covered in full
    double flow = 0.5;      // of the full effect that one dab has in its middle
    double opacity = 1;     // of the full effect: a whole stroke has no more
    double spacing = 0.2;   // between two dabs, radii
    double value = 1;       // that is painted, of full paint
    Blend blend = Blend::replace;
    Follows radius_follows = Follows::nothing, flow_follows = Follows::nothing;

    bool operator==(const Brush&) const = default;
};

// The hand at a place of its path, each from 0 to 1.
struct Touch {
    double pressure = 1;
    double slowness = 1;  // 1 at rest, 1/2 at a usual pace
};

// Part of the way from one touch to another.
Touch between(const Touch& a, const Touch& b, double part);

// The brush under such a hand: at its lightest a tenth as wide, and without effect where flow follows.
Brush touched(const Brush& brush, const Touch& touch);

inline constexpr double brush_radius_min = 0.5, brush_radius_max = 60;  // degrees
inline constexpr double spacing_min = 0.05, spacing_max = 2;            // radii

// What becomes of a value under this much of the brush, from 0 to 1. Values stay in [0, 1].
double painted(const Brush& brush, double value, double amount);

// How much a brush covers at `distance` radii from its middle: 1 up to its hardness, then smoothly down to 0
// at 1.
double brush_falloff(const Brush& brush, double distance);

// Angle between two unit vectors, radians; keeps its digits for small angles.
double angle_between(dvec3 a, dvec3 b);

// The smallest rotation that takes unit vector a to b; a and b not opposite.
glm::dmat3 shortest_rotation(dvec3 a, dvec3 b);

// How one stroke becomes several, about the layer's own axis.
enum class SymmetryKind {
    none,
    mirror_x,     // left and right: x to -x
    mirror_y,     // y to -y
    mirror_both,  // four quarters
    turns,        // rotated copies
    ring          // all the way around
};

struct BrushSymmetry {
    SymmetryKind kind = SymmetryKind::none;
    int turns = 6;

    bool operator==(const BrushSymmetry&) const = default;
};

inline constexpr int turns_min = 2, turns_max = 24;

// Orthogonal matrices that take the stroke to each of its copies, the identity first. A full ring has no
// finite set of them: the identity alone.
std::vector<glm::dmat3> symmetry_images(const BrushSymmetry& symmetry);

}  // namespace nacre
