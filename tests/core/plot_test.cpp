#include "core/plot/plot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "core/bake/brdf.h"
#include "core/formats/plot_files.h"
#include "core/image/luminance.h"
#include "core/model/polar_angles.h"
#include "core/plot/curve_sampler.h"
#include "core/plot/pair_plots.h"
#include "tests/core/plots.h"
#include "tests/core/property.h"
#include "tests/core/well_formed.h"

using namespace nacre;
using namespace nacre::test;

TEST_SUITE_BEGIN("plot");

TEST_CASE("axis: ticks are even, on the axis, no more than asked for, and place and value are inverse") {
    for (const bool logarithmic : {false, true})
        for (const double highest : {1e-7, 0.0042, 0.085, 1.0, 3.7, 99.0, 1e12})
            for (const int most : {2, 5, 9}) {
                const Axis axis = value_axis("", "", highest, logarithmic);
                CAPTURE(highest);
                CHECK(axis.high >= highest * (1 - 1e-9));
                CHECK(axis.high <= highest * (logarithmic ? 10.001 : 1.3));
                const std::vector<Tick> ticks = axis.ticks(most);
                REQUIRE(ticks.size() >= 1);
                CHECK(ticks.size() <= std::size_t(most));
                for (std::size_t i = 0; i < ticks.size(); ++i) {
                    const double place = axis.place(ticks[i].value);
                    CHECK(axis.value(place) == doctest::Approx(ticks[i].value));
                    if (i >= 2)
                        CHECK(
                            place - axis.place(ticks[i - 1].value) ==
                            doctest::Approx(axis.place(ticks[i - 1].value) - axis.place(ticks[i - 2].value)));
                }
            }
    const Axis degrees = angle_axis("", -90, 90);
    CHECK(degrees.ticks(7).size() == 7);
    CHECK(degrees.ticks(7)[1].label == "-60\u00b0");
    CHECK(value_axis("", "", 0.3, false, 1).high == 1);
    CHECK(value_axis("", "", 2, true).place(NAN) == 0);
    CHECK(value_axis("", "", 0, false).ticks(4).size() >= 1);
}

TEST_CASE("sampled curves find a peak a thousandth of their range wide and keep to their chords") {
    const auto peak = [](double x) {
        return std::exp(-std::pow((x - 31.4) / 0.03, 2)) + 0.1 * std::sin(x / 9);
    };
    const SampledCurves curves =
        sample_curves({.low = 0, .high = 90, .hints = {31.4}}, 1,
                      [&](double x, std::span<double> values) { values[0] = peak(x); });
    CHECK(curves.at.front() == 0);
    CHECK(curves.at.back() == 90);
    CHECK(curves.at.size() < 400);
    double most = 0, worst = 0;
    for (std::size_t i = 1; i < curves.at.size(); ++i) {
        CHECK(curves.at[i] > curves.at[i - 1]);
        most = std::max(most, curves.values[0][i]);
        const double middle = 0.5 * (curves.at[i] + curves.at[i - 1]);
        worst =
            std::max(worst, std::fabs(peak(middle) - 0.5 * (curves.values[0][i] + curves.values[0][i - 1])));
    }
    CHECK(most == doctest::Approx(peak(31.4)));
    CHECK(worst < 0.01);
}

TEST_CASE("R is what the tables hold, at every f0, and what lies between f0 = 0 and 1 is the material") {
    for (const Design& design : {coloured(design_of(GgxLobe{0.3, 0.3})), coloured(two_sided())}) {
        const auto tables = baked(design);
        const CurvePlot plot = curves_of(*tables, settings_of(PlotKind::albedo));
        const bool round = tables->needs.symmetry.symmetry == Symmetry::isotropic;
        REQUIRE(plot.series.size() == (round ? 5 : 12));
        const std::size_t zero = round ? 3 : 1, one = round ? 4 : 2;
        for (std::size_t i = 0; i < plot.at.size(); ++i) {
            dvec3 k = polar_direction(plot.at[i], tables->needs.symmetry.axis);
            k.z = std::max(k.z, 0.0);
            const AlbedoValues values = read_albedo(tables->shading, k, 1);
            CHECK(plot.series[zero].values[i] == values[1]);
            CHECK(plot.series[one].values[i] == values[0]);
            const dvec3 material = glm::mix(dvec3(values[1]), dvec3(values[0]), dvec3(0.9, 0.5, 0.2));
            CHECK(plot.series[0].values[i] ==
                  doctest::Approx(round ? material.x : luminance(material)).epsilon(1e-9));
        }
    }
    Design metal = design_of(GgxLobe{0.2, 0.2});
    metal.fresnel = ConductorFresnel{};
    CHECK(curves_of(*baked(metal), settings_of(PlotKind::albedo)).series.size() == 4);
    const auto bare = bake(design_of(GgxLobe{0.2, 0.2}), {.quality = Quality::draft});
    CHECK(!make_plot(*bare, settings_of(PlotKind::albedo)));
    CHECK(make_plot(*bare, settings_of(PlotKind::masking)));
}

TEST_CASE("masking is GGX's closed form, 1 at the normal; without the clamp it may exceed 1") {
    const CurvePlot ggx = curves_of(*baked(design_of(GgxLobe{0.5, 0.5})), settings_of(PlotKind::masking));
    CHECK(ggx.series[0].values.front() == doctest::Approx(1));
    for (std::size_t i = 0; i < ggx.at.size(); ++i) {
        const double c = polar_direction(ggx.at[i], 0).z, r = std::hypot(0.5 * std::sqrt(1 - c * c), c);
        CHECK(ggx.series[0].values[i] == doctest::Approx(2 * c / (c + r)).epsilon(0.01));
    }
    const auto highest = [](const CurvePlot& plot) {
        double most = 0;
        for (const Series& series : plot.series)
            for (const double value : series.values) most = std::max(most, value);
        return most;
    };
    CHECK(highest(curves_of(*baked(slanted_velvet(2, true)), settings_of(PlotKind::masking))) == 1);
    CHECK(highest(curves_of(*baked(slanted_velvet(2, false)), settings_of(PlotKind::masking))) > 1.5);
}

TEST_CASE("a plot follows the settings that it says it reads, and no others") {
    const auto tables = baked(coloured(two_sided()));
    for (const PlotKind kind : plot_kinds) {
        CAPTURE(name_of(kind));
        PlotSettings settings = settings_of(kind);
        settings.slice_side = 9;
        const auto numbers = [&](const PlotSettings& of) { return plot_csv(*make_plot(*tables, of)); };
        const std::string before = numbers(settings);
        PlotSettings other = settings;
        other.term = Term::specular;
        CHECK((numbers(other) != before) == info(kind).has_term);
        for (double PlotSettings::*angle :
             {&PlotSettings::incidence, &PlotSettings::azimuth, &PlotSettings::turn}) {
            const auto& read = info(kind).angles;
            other = settings;
            other.*angle += 17;
            CHECK((numbers(other) != before) == std::any_of(read.begin(), read.end(), [&](const auto& one) {
                      return one.member == angle;
                  }));
        }
    }
}

TEST_CASE("property: P lies in [0, 1] under the clamp, and every plot of every design can be drawn") {
    CHECK(holds(
        "plots",
        [] {
            Design design = physical_design();
            design.shadowing.clamp = true;
            const auto tables = bake(design, {.quality = Quality::draft, .albedo = true});
            for (const Series& series : curves_of(*tables, settings_of(PlotKind::masking)).series)
                for (const double value : series.values) RC_ASSERT(value >= 0 && value <= 1);
            for (const PlotKind kind : plot_kinds) {
                PlotSettings settings = settings_of(kind);
                settings.slice_side = 9;
                settings.logarithmic.fill(*rc::gen::arbitrary<bool>());
                const std::string svg = plot_svg(*make_plot(*tables, settings));
                RC_ASSERT(is_well_formed(svg));
                RC_ASSERT(!std::regex_search(svg, std::regex("\\b(nan|inf)\\b")));
            }
        },
        8));
}

TEST_CASE("a lobe holds the BRDF; of a round p it is symmetric at normal incidence, and reciprocal") {
    const auto tables = baked(coloured(design_of(GgxLobe{0.3, 0.3})));
    const Brdf brdf(tables);
    PlotSettings settings = settings_of(PlotKind::lobe);
    settings.azimuth = 25;
    const CurvePlot plot = curves_of(*tables, settings);
    REQUIRE(plot.series.size() == 3);
    for (std::size_t i = 0; i < plot.at.size(); ++i) {
        const dvec3 rho = brdf.evaluate(polar_direction(45, 205), polar_direction(plot.at[i], 25));
        CHECK(plot.series[0].values[i] == rho.x);
        CHECK(plot.series[2].values[i] == rho.z);
    }
    const auto lobe_at = [&](double incidence) {
        settings.incidence = incidence;
        return curves_of(*tables, settings);
    };
    const CurvePlot upright = lobe_at(0), steep = lobe_at(30), grazing = lobe_at(70);
    for (double x = 0; x < 89; x += 3.1)
        CHECK(upright.value(0, x) == doctest::Approx(upright.value(0, -x)).epsilon(0.02));
    CHECK(steep.value(0, 70) == doctest::Approx(grazing.value(0, 30)).epsilon(0.02));
    CHECK(steep.value(0, -70) == doctest::Approx(grazing.value(0, -30)).epsilon(0.02));
}

TEST_CASE("the peak of a lobe a hundredth wide is drawn whole, and so is a leaning one's") {
    for (const double tilt : {0.0, 15.0}) {
        const auto tables = baked(design_of(GaussianLobe{0.01, 0.01}, tilt));
        const Brdf brdf(tables);
        PlotSettings settings = settings_of(PlotKind::lobe, Term::specular);
        settings.incidence = 20;
        const CurvePlot plot = curves_of(*tables, settings);
        double drawn = 0, finest = 0;
        for (const double value : plot.series[0].values) drawn = std::max(drawn, value);
        for (int i = -400; i <= 400; ++i)
            finest = std::max(
                finest,
                brdf.evaluate(polar_direction(20, 180), polar_direction(20 + 2 * tilt + i * 0.005, 0)).x);
        CHECK(drawn == doctest::Approx(finest).epsilon(0.02));
    }
}

TEST_CASE("a shape's directions are unit, above the horizon, begin at the mirror, and hold the BRDF") {
    for (const double incidence : {0.0, 45.0, 89.9}) {
        const auto tables = baked(two_sided());
        const Brdf brdf(tables);
        PlotSettings settings = settings_of(PlotKind::lobe3d, Term::specular);
        settings.incidence = incidence;
        settings.azimuth = 70;
        const Plot plot = *make_plot(*tables, settings);
        const auto& shape = std::get<ShapePlot>(plot.contents);
        REQUIRE(shape.k2.size() == std::size_t(1 + shape.rings * shape.spokes));
        REQUIRE(shape.k2.size() < 65536);
        const dvec3 mirror(-shape.k1.x, -shape.k1.y, shape.k1.z);
        CHECK(glm::length(shape.k2[0] - mirror) < 1e-12);
        for (std::size_t i = 0; i < shape.k2.size(); ++i) {
            CHECK(std::fabs(glm::length(shape.k2[i]) - 1) < 1e-12);
            CHECK(shape.k2[i].z > 0);
            CHECK(shape.values[i] == brdf.evaluate(shape.k1, shape.k2[i], Term::specular));
        }
        // The last ring lies at the horizon, all around.
        for (int spoke = 0; spoke < shape.spokes; ++spoke)
            CHECK(shape.k2[shape.k2.size() - 1 - std::size_t(spoke)].z < 1e-3);
    }
}

TEST_CASE("a slice holds the BRDF at the angles of half and difference vector") {
    const auto tables = baked(two_sided());
    const Brdf brdf(tables);
    for (const double turn : {90.0, 20.0}) {
        PlotSettings settings = settings_of(PlotKind::slice);
        settings.slice_side = 19;
        settings.azimuth = 35;
        settings.turn = turn;
        const Plot plot = *make_plot(*tables, settings);
        const auto& slice = std::get<SlicePlot>(plot.contents);
        for (int row = 0; row < 19; ++row)
            for (int column = 0; column < 19; ++column) {
                const double theta_h = slice.angle(column), theta_d = slice.angle(row);
                const ReflectedPair pair = HalfFrame(theta_h, 35).pair(polar_direction(theta_d, turn));
                const dvec3 h = glm::normalize(pair.k1 + pair.k2);
                CHECK(polar_angle(h) == doctest::Approx(theta_h).epsilon(1e-6));
                CHECK(std::acos(std::min(glm::dot(pair.k1, h), 1.0)) ==
                      doctest::Approx(theta_d * std::acos(-1.0) / 180).epsilon(1e-5));
                CHECK(slice.values[std::size_t(row * 19 + column)] == brdf.evaluate(pair.k1, pair.k2));
            }
    }
}

TEST_CASE("the colours of a slice are not used up by a correlated masking that grows at grazing") {
    Design design = design_of(GgxLobe{0.3, 0.3});
    design.shadowing.model = SmithCorrelatedMasking{};
    const auto tables = baked(design);
    const Plot plot = *make_plot(*tables, settings_of(PlotKind::slice));
    const auto& slice = std::get<SlicePlot>(plot.contents);
    CHECK(luminance(slice.values[std::size_t(slice.side * (slice.side - 1))]) > 100 * slice.shade.high);
    CHECK(slice.shade.place(luminance(slice.values[0])) > 0.2);
}

TEST_CASE("every term alone, as a lobe: factors that multiply to the specular term") {
    Design design = coloured(design_of(GgxLobe{0.4, 0.4}));
    const auto tables = baked(design);
    const auto value = [&](Term term, std::size_t channel) {
        const CurvePlot plot = curves_of(*tables, settings_of(PlotKind::lobe, term));
        return plot.value(std::min(channel, plot.series.size() - 1), 45);
    };
    const double N = tables->shading.surface.N;
    for (const std::size_t channel : {0u, 2u}) {
        const double factors = 0.25 * N * value(Term::density, 0) * value(Term::fresnel, channel) *
                               value(Term::inverse_areas, 0);
        CHECK(value(Term::specular, channel) == doctest::Approx(factors).epsilon(1e-6));
        CHECK(value(Term::total, channel) ==
              doctest::Approx(factors + value(Term::diffuse, channel)).epsilon(1e-6));
    }
    CHECK(value(Term::masking1, 0) == doctest::Approx(value(Term::masking2, 0)));
}

TEST_SUITE_END();
