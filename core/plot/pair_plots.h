// What plots over pairs of directions have in common.
#pragma once

#include <string>
#include <vector>

#include "core/bake/brdf.h"
#include "core/plot/plot.h"

namespace nacre {

inline constexpr double horizon = 90 - 1e-3;  // degrees: as near to it as a direction above it needs to be

// Of a lobe: where the light k1 comes from.
inline constexpr PlotAngle incidence_angles[] = {
    {.member = &PlotSettings::incidence,
     .name = "incidence",
     .label = "Incidence",
     .low = 0,
     .high = incidence_max,
     .about = "Angle of the light k1 from the normal. Dragging in the polar plot sets it too."},
    {.member = &PlotSettings::azimuth,
     .name = "azimuth",
     .label = "Azimuth",
     .low = -180,
     .high = 180,
     .about = "Toward which azimuth a mirror would send the light: the plane of incidence lies along it."}};

dvec3 incident_direction(const PlotSettings& settings);
std::string incidence_text(const PlotSettings& settings);

// Rusinkiewicz (1998): k1 and k2 of the angles of the half vector h and of the difference vector, which is k1
// seen in the frame of h. theta_h = theta_d = 0 is the mirror at normal incidence; along theta_d at theta_h =
// 0 runs the Fresnel peak, and the slice of phi_d = 90 degrees is the picture of Burley (2012, fig. 2).
struct ReflectedPair {
    dvec3 k1, k2;
};

// The frame of a half vector: z = h, x along rising theta. Degrees.
struct HalfFrame {
    dvec3 along, across, h;

    HalfFrame(double theta_h, double phi_h);
    ReflectedPair pair(const dvec3& difference) const;
};

// A term's name in a title.
std::string words_of(Term term);
Axis term_axis(Term term, double highest, bool logarithmic);
double highest_luminance(const std::vector<dvec3>& values);

// The term for one k1, read from the tables once, and any k2.
class TermOf {
  public:
    TermOf(const Tables& tables, dvec3 k1, Term term)
        : shading_(tables.shading), a_(shading_.direction(k1)), term_(term) {}

    dvec3 operator()(dvec3 k2) const { return brdf_term(shading_, a_, shading_.direction(k2), term_); }

  private:
    const Shading<double>& shading_;
    Shading<double>::Direction a_;
    Term term_;
};

}  // namespace nacre
