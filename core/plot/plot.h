// Plots of a baked design as values: what the designer draws and what is saved.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/bake/tables.h"
#include "core/plot/axis.h"
#include "core/shading/term.h"

namespace nacre {

enum class PlotKind {
    albedo,   // R over the angle from the normal
    masking,  // P over the angle from the normal
    density,  // p over the angle of the facet's normal
    fresnel,  // F over the angle between a facet's normal and the light
    lobe,     // a term over k2 in the plane of incidence, polar
    shape,    // the same over all k2, as a shape in space
    slice     // a term over the half vector's and the difference angle
};
inline constexpr int plot_kinds = 7;

// Angles in degrees.
struct PlotSettings {
    PlotKind kind = PlotKind::albedo;
    Term term = Term::total;  // of lobe, shape and slice
    double incidence = 45;    // of k1 from n; lobe and shape
    double azimuth = 0;       // of the mirror direction (lobe and shape) or of h (slice)
    double turn = 90;         // phi_d of the slice
    std::array<bool, plot_kinds> logarithmic = {false, false, false, false, false, false, true};
    int slice_side = 91;  // values along each side of a slice

    bool is_logarithmic() const { return logarithmic[static_cast<std::size_t>(kind)]; }
    bool operator==(const PlotSettings&) const = default;
};

inline constexpr double incidence_most = 89.9;

// Colours are told by their part, so that the screen and a file can choose what suits their ground: first the
// frame's, then the series'.
enum class Ink { text, quiet, grid, plain, red, green, blue, first, second, third, fourth };
enum class Dash { solid, dashed, dotted };

struct Series {
    std::string name;
    Ink ink = Ink::plain;
    Dash dash = Dash::solid;
    std::vector<double> values = {};
};

// Curves over a common abscissa, which lies denser where any of them bends.
struct CurvePlot {
    Axis x, y;
    std::vector<double> at = {};  // rising
    std::vector<Series> series = {};

    // Of one series, by straight lines between the points; the ends' values beyond them.
    double value(std::size_t of, double where) const;
};

// Curves over the angle of k2 in the plane of incidence, positive on the mirror's side; their distance from
// the middle is the place on the axis y.
struct LobePlot {
    CurvePlot curves;
    double incidence;  // degrees
};

// A term over all k2: rings around the mirror direction, from it (one direction) to the horizon.
struct ShapePlot {
    int rings, spokes;
    std::vector<dvec3> k2 = {};      // the mirror direction, then ring by ring
    std::vector<dvec3> values = {};  // each colour
    dvec3 k1{0, 0, 1};
    Axis radius = {};  // of the luminance
};

// A term over theta_h (along x) and theta_d (along y).
struct SlicePlot {
    Axis x, y;
    int side;
    std::vector<dvec3> values = {};  // row by row from theta_d = 0, each from theta_h = 0
    Axis shade = {};                 // of the luminance

    // Of a row or a column, degrees; the last stands a thousandth before 90, where no direction is above the
    // horizon.
    double angle(int index) const;
};

struct Plot {
    std::string title;     // what it shows
    std::string subtitle;  // for which directions
    std::variant<CurvePlot, LobePlot, ShapePlot, SlicePlot> contents;
};

// Whether the tables must hold R.
bool needs_albedo(const PlotSettings& settings);

// Nothing where the tables lack R and the plot needs it.
std::optional<Plot> make_plot(const Tables& tables, const PlotSettings& settings);

// The light's direction of a lobe or a shape.
dvec3 incident_direction(const PlotSettings& settings);

// Rusinkiewicz (1998): k1 and k2 of the angles of the half vector h and of the difference vector, which is k1
// seen in the frame of h. theta_h = theta_d = 0 is the mirror at normal incidence; along theta_d at theta_h =
// 0 runs the Fresnel peak, and the slice of phi_d = 90 degrees is the picture of Burley (2012, fig. 2).
struct ReflectedPair {
    dvec3 k1, k2;
};
ReflectedPair half_difference_pair(double theta_h, double phi_h, double theta_d, double phi_d);

// "albedo", "masking", ... as the command line has them.
const char* name_of(PlotKind kind);
std::optional<PlotKind> plot_kind(const std::string& name);

}  // namespace nacre
