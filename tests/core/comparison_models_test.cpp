// The models that a design is compared with: values worked out by hand, what they have in common with p, and
// the widths they are given.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/compare/closed_form.h"
#include "core/compare/facet_slopes.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;
using Shader = Shading<double>;
using Form = Shader::ClosedForm;

dvec3 at(double theta, double phi = 0) { return polar(std::cos(theta * pi / 180), phi * pi / 180); }

Form form_of(ClosedFormModel model, double alpha_x, double alpha_y) {
    Form form{};
    form.model = static_cast<int>(model);
    form.axis = {1, 0};
    form.width = {alpha_x, alpha_y};
    form.inverse_width = 1.0 / form.width;
    form.scale = 1 / (pi * alpha_x * alpha_y);
    return form;
}

Form oren_nayar(double sigma, double rho) {
    Form form = form_of(ClosedFormModel::oren_nayar, 1, 1);
    form.sigma2 = sigma * sigma;
    form.rho = dvec3{rho};
    return form;
}

// A surface with F = 1 and nothing diffuse, of a lobe that no model is.
std::shared_ptr<const Tables> mirror_facets(Lobe lobe = GaussianLobe{0.2, 0.2}) {
    Design design = design_of(std::move(lobe));
    design.fresnel = NoFresnel{};
    design.diffuse = NoDiffuse{};
    return bake(design, {.quality = Quality::draft});
}

}  // namespace

TEST_SUITE_BEGIN("comparison models");

TEST_CASE("Ward 1992, eq. 5a, by hand") {
    const Form brass = form_of(ClosedFormModel::ward, 0.05, 0.16);
    // At the normal: 1/(4 pi 0.05 0.16).
    CHECK(Shader::ward(brass, at(0), at(0)) == doctest::Approx(9.947184).epsilon(1e-6));
    // Mirrored at 60 degrees, delta = 0 and sqrt(cos 60 cos 60) = 1/2: twice that.
    CHECK(Shader::ward(brass, at(60), at(60, 180)) == doctest::Approx(19.894368).epsilon(1e-6));
    // 20 degrees toward y, delta = 10: exp(-0.0310912/0.0256) = 0.296858 over sqrt(0.9396926) = 0.969378.
    CHECK(Shader::ward(brass, at(0), at(20, 90)) == doctest::Approx(3.046187).epsilon(1e-6));
}

TEST_CASE("Oren and Nayar 1994, eq. 27 to 29, by hand") {
    // sigma = 0.5, rho = 0.8: C1 = 1 - 0.125/0.58 = 0.784483, 0.25/0.34 = 0.735294,
    // 0.17 rho 0.25/0.38 = 0.0894737; rho/pi = 0.254648.
    const Form form = oren_nayar(0.5, 0.8);
    const auto value = [&](dvec3 k1, dvec3 k2) { return Shader::oren_nayar(form, k1, k2).y; };
    // At the normal beta = 0: rho/pi (0.784483 + 0.0894737).
    CHECK(value(at(0), at(0)) == doctest::Approx(0.222551).epsilon(1e-5));
    // Back to the light at 45: C2 tan beta = 0.45 0.735294 sin 45 = 0.233970; 1 - (2 beta/pi)^2 = 3/4:
    // rho/pi (0.784483 + 0.233970 + 0.0671053).
    CHECK(value(at(45), at(45)) == doctest::Approx(0.276435).epsilon(1e-5));
    // Square to each other at 60 and 30: C3 = 0.125 0.735294 (4 (pi/3)(pi/6)/pi^2)^2 = 0.00453886, tan 45 =
    // 1: rho/pi (0.784483 + 0.00453886 + 0.0894737).
    CHECK(value(at(60), at(30, 90)) == doctest::Approx(0.223707).epsilon(1e-5));
    // Away from the light: C2 = 0.45 0.735294 (sin 60 - (1/3)^3) = 0.274298, times -tan 30 = -0.158366;
    // 1 + (1/3)^2: rho/pi (0.784483 - 0.158366 + 0.0994152).
    CHECK(value(at(60), at(30, 180)) == doctest::Approx(0.184755).epsilon(1e-5));
    // Smooth facets are Lambert's.
    CHECK(Shader::oren_nayar(oren_nayar(0, 0.8), at(50, 20), at(70, 130)).x ==
          doctest::Approx(0.8 / pi).epsilon(1e-12));
}

TEST_CASE("Cook and Torrance 1982 by hand") {
    const Form form = form_of(ClosedFormModel::beckmann, 0.5, 0.5);
    const auto value = [&](dvec3 k1, dvec3 k2) {
        const Shader shading;
        const auto between = shading.half_vector(k1, k2);
        return Shader::cook_torrance(form, k1, k2, between.h, between.cosine);
    };
    // D = 1/(pi 0.25) at the normal, over 4.
    CHECK(value(at(0), at(0)) == doctest::Approx(0.3183099).epsilon(1e-6));
    // Mirrored at 70: G = min(1, 2 cos(70)/cos(70)) = 1, over 4 cos^2(70).
    CHECK(value(at(70), at(70, 180)) == doctest::Approx(0.3183099 / 0.1169778).epsilon(1e-6));
    // Back to the light at 60: h = k, D = exp(-3/0.25)/(pi 0.25 cos^4(60)) = 1.251834e-4, G = 2 (1/2)^2 = 1/2
    // over 4 (1/2)^2.
    CHECK(value(at(60), at(60)) == doctest::Approx(6.259172e-5).epsilon(1e-5));
}

TEST_CASE("every model is reciprocal to the last bit, finite and not negative") {
    const auto tables = mirror_facets();
    Random random(5);
    for (const ClosedFormInfo& model : all_closed_forms())
        for (const double width : {0.02, 0.3, 2.0}) {
            Form form = form_of(model.model, width, 0.5 * width);
            form.axis = {0.6, 0.8};
            form.sigma2 = width;
            form.rho = {1, 0.5, 0.1};
            for (int i = 0; i < 300; ++i) {
                const dvec3 k1 = random_direction(random), k2 = random_direction(random);
                const dvec3 rho = closed_form_brdf(tables->shading, form, k1, k2);
                CHECK(rho == closed_form_brdf(tables->shading, form, k2, k1));
                CHECK(std::isfinite(rho.x));
                CHECK(rho.x >= 0);
            }
        }
}

TEST_CASE("GGX with Smith's height-correlated masking is a case of this model") {
    Design design = design_of(GgxLobe{0.1, 0.3});
    design.fresnel = NoFresnel{};
    design.diffuse = NoDiffuse{};
    design.shadowing.model = SmithCorrelatedMasking{};
    const auto tables = bake(design);
    const Form form = form_of(ClosedFormModel::ggx, 0.1, 0.3);
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        const dvec3 k1 = random_direction(random), k2 = random_direction(random);
        const double ours = Brdf(tables).evaluate(k1, k2).x;
        CHECK(closed_form_brdf(tables->shading, form, k1, k2).x == doctest::Approx(ours).epsilon(4e-3));
    }
}

TEST_CASE("Beckmann's facets are p's; V-grooves hide other facets than Smith's surface does") {
    const auto tables = mirror_facets(BeckmannLobe{0.3, 0.3});
    const Form form = form_of(ClosedFormModel::beckmann, 0.3, 0.3);
    const Shader& shading = tables->shading;
    // Where nothing is hidden both are D/(4 c1 c2).
    CHECK(closed_form_brdf(shading, form, at(10), at(10, 180)).x ==
          doctest::Approx(Brdf(tables).evaluate(at(10), at(10, 180)).x).epsilon(2e-3));
    // A mirror direction's grooves are open at every angle, while Smith's facets hide one another.
    CHECK(closed_form_brdf(shading, form, at(80), at(80, 180)).x >
          1.2 * Brdf(tables).evaluate(at(80), at(80, 180)).x);
}

TEST_CASE("Ward: at the normal nearly everything comes back, as he says for narrow lobes") {
    // With F = 1 the table of albedo is what the model gives back of what falls in.
    Design design = design_of(GaussianLobe{0.1, 0.1});
    design.fresnel = NoFresnel{};
    design.diffuse = NoDiffuse{};
    const auto tables = bake(design, {.quality = Quality::draft, .albedo = true});
    const ClosedForm ward = matching_form(*tables, ClosedFormModel::ward);
    REQUIRE(ward.albedo.size() == 3u * Shader::MODEL_NODES * Shader::MODEL_AZIMUTHS);
    CHECK(ward.albedo[0] > 0.97f);
    CHECK(ward.albedo[0] < 1.0f);
    // Oren and Nayar's smooth facets give back rho from everywhere.
    const ClosedForm lambert = matching_form(*tables, ClosedFormModel::oren_nayar);
    CHECK(lambert.form.rho.x == doctest::Approx(tables->mean_albedo.x).epsilon(2e-3));
    CHECK(static_cast<double>(lambert.albedo[0]) == doctest::Approx(lambert.form.rho.x).epsilon(0.05));
}

TEST_CASE("a model of matching width finds its own alpha again") {
    const struct {
        Lobe lobe;
        ClosedFormModel model;
        dvec2 alpha;
    } cases[] = {
        {GgxLobe{0.3, 0.05}, ClosedFormModel::ggx, {0.3, 0.05}},
        {GgxLobe{1.5, 1.5}, ClosedFormModel::ggx, {1.5, 1.5}},
        {BeckmannLobe{0.2, 0.6}, ClosedFormModel::beckmann, {0.2, 0.6}},
        {BeckmannLobe{0.01, 0.01}, ClosedFormModel::ward, {0.01, 0.01}},
    };
    for (const auto& c : cases)
        for (const double rotation : {0.0, 35.0}) {
            const auto tables = bake(design_of(c.lobe, 0, 0, rotation), {.quality = Quality::draft});
            const Form form = matching_form(*tables, c.model).form;
            // The first axis is the one along which facets lean least.
            const dvec2 wanted{std::fmin(c.alpha.x, c.alpha.y), std::fmax(c.alpha.x, c.alpha.y)};
            CHECK(form.width.x == doctest::Approx(wanted.x).epsilon(0.01));
            CHECK(form.width.y == doctest::Approx(wanted.y).epsilon(0.01));
            if (c.alpha.x == c.alpha.y) continue;
            const double azimuth = (rotation + (c.alpha.x > c.alpha.y ? 90 : 0)) * pi / 180;
            CHECK(std::fabs(form.axis.x * std::cos(azimuth) + form.axis.y * std::sin(azimuth)) ==
                  doctest::Approx(1).epsilon(1e-4));
        }
}

TEST_CASE("widths exist for every p: endless cylinders, velvet, a painted ring") {
    const Picture ring = picture_of(32, [](double x, double y) {
        const double r = std::hypot(x, y);
        return r > 0.4 && r < 0.6 ? 1.0 : 0.0;
    });
    for (const Lobe& lobe : {Lobe{GaussianLobe{0.1, limits::infinity}}, Lobe{InverseGaussianLobe{0.5}},
                             Lobe{PaintedLobe{ring}}}) {
        const FacetSlopes slopes = facet_slopes(FacetDistribution(design_of(lobe).distribution));
        CHECK(slopes.median.x > 0.02);
        CHECK(slopes.median.y < 20);
    }
    // Along an endless cylinder of eq. 34 the band of normals narrows as cos(t), and n sees cos^2(t) of it:
    // half of that lies within t with t + sin(t) cos(t) = pi/4, tan(t) = 0.441611.
    const FacetSlopes cylinder =
        facet_slopes(FacetDistribution(design_of(GaussianLobe{0.001, limits::infinity}).distribution));
    CHECK(cylinder.median.y == doctest::Approx(0.441611).epsilon(0.01));
    // The first axis lies across it.
    CHECK(std::fabs(std::sin(cylinder.azimuth)) < 1e-3);
}

TEST_CASE("the factors multiply to the specular term") {
    for (std::size_t masking = 0; masking < KindSet<MaskingModel>::count; ++masking) {
        Design design = with_layer(design_of(GgxLobe{0.2, 0.4}), GaussianLobe{0.1, 0.3}, 0.5, 20, 40);
        design.fresnel = ConductorFresnel{};
        design.shadowing.model = KindSet<MaskingModel>::made(masking);
        const auto tables = bake(design, {.quality = Quality::draft});
        const Brdf brdf(tables);
        const double N = tables->shading.surface.N;
        Random random(3);
        for (int i = 0; i < 200; ++i) {
            const dvec3 k1 = random_direction(random), k2 = random_direction(random);
            const auto term = [&](Term t) { return brdf.evaluate(k1, k2, t); };
            const dvec3 product =
                term(Term::fresnel) * term(Term::density) * (N / 4) * term(Term::inverse_areas);
            const dvec3 specular = term(Term::specular);
            for (int c = 0; c < 3; ++c) CHECK(product[c] == doctest::Approx(specular[c]).epsilon(1e-12));
            if (std::holds_alternative<UncorrelatedMasking>(design.shadowing.model))
                CHECK(term(Term::masking1).x * term(Term::masking2).x ==
                      doctest::Approx(term(Term::inverse_areas).x * N * N * k1.z * k2.z).epsilon(1e-12));
            CHECK(term(Term::masking1).x <= 1);
        }
    }
}

TEST_SUITE_END();
