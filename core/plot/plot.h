// Plots of a baked design as values: what the designer draws and what is saved.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/bake/tables.h"
#include "core/plot/axis.h"
#include "core/shading/term.h"

namespace nacre {

// One file for each, core/plot/kinds/NAME.cpp, and its line in plot_list.inc, which the command line and the
// window follow.
enum class PlotKind {
#define PLOT(name) name,
#include "core/plot/plot_list.inc"
#undef PLOT
};

inline constexpr PlotKind plot_kinds[] = {
#define PLOT(name) PlotKind::name,
#include "core/plot/plot_list.inc"
#undef PLOT
};

// Of each kind, whether its scale is logarithmic.
using PlotScales = std::array<bool, std::size(plot_kinds)>;
PlotScales usual_scales();

// What a kind does not read is without effect on it. Angles in degrees.
struct PlotSettings {
    PlotKind kind = PlotKind::albedo;
    Term term = Term::total;
    double incidence = 45;  // of k1 from n
    double azimuth = 0;     // of the mirror direction or of h
    double turn = 90;       // phi_d
    PlotScales logarithmic = usual_scales();
    int slice_side = 91;  // values along each side of a slice

    bool is_logarithmic() const { return logarithmic[static_cast<std::size_t>(kind)]; }
    bool operator==(const PlotSettings&) const = default;
};

inline constexpr double incidence_max = 89.9;

// Colours are named by their role, so that the screen and a file can choose what suits their background:
// first the frame's, then the series'.
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

    // Of a row or a column, degrees; the last is a thousandth before 90, where no direction is above the
    // horizon.
    double angle(int index) const;
};

struct Plot {
    std::string title;     // what it shows
    std::string subtitle;  // for which directions
    std::variant<CurvePlot, LobePlot, ShapePlot, SlicePlot> contents;
};

// An angle that a kind reads of the settings.
struct PlotAngle {
    double PlotSettings::*member;
    const char* name;
    const char* label;
    double low, high;  // degrees
    const char* about;
};

struct PlotInfo {
    const char* label;  // on its button
    const char* about;
    bool needs_albedo = false;               // the tables must hold R
    bool has_term = false;                   // it reads PlotSettings::term
    std::span<const PlotAngle> angles = {};  // that it reads
    bool logarithmic = false;                // until another scale is chosen
    Plot (*make)(const Tables& tables, const PlotSettings& settings);
};

const PlotInfo& info(PlotKind kind);

#define PLOT(name) extern const PlotInfo name##_plot;
#include "core/plot/plot_list.inc"
#undef PLOT

bool needs_albedo(const PlotSettings& settings);

// Nothing where the tables lack R and the plot needs it.
std::optional<Plot> make_plot(const Tables& tables, const PlotSettings& settings);

// As the command line has them.
const char* name_of(PlotKind kind);
std::optional<PlotKind> plot_kind(const std::string& name);

}  // namespace nacre
