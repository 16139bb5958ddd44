// Multiple bounces as they render: energy, reciprocity, colour, and where the light goes.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/bake/baker.h"
#include "core/bake/brdf.h"
#include "core/design/design_check.h"
#include "core/design/design_file.h"
#include "core/verify/bounce_check.h"
#include "core/verify/bounce_oracle.h"
#include "core/verify/physics_check.h"
#include "tests/core/cheap.h"
#include "tests/core/dense_bounces.h"
#include "tests/core/random_directions.h"
#include "tests/core/reciprocity.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

Design of(const Lobe& lobe, const Multibounce& bounces = MomentumMultibounce{}) {
    Design design;
    design.distribution.layers.assign(1, Layer{});
    design.distribution.layers[0].lobe = lobe;
    design.fresnel = NoFresnel{};
    design.multibounce = bounces;
    return design;
}

Design grooves(double width, const Multibounce& bounces = MomentumMultibounce{}) {
    Design design = of(GaussianLobe{width, width}, bounces);
    design.distribution.layers[0].tilt = 45;
    design.distribution.layers.push_back(design.distribution.layers[0]);
    design.distribution.layers[1].azimuth = 180;
    return design;
}

// Energy that the tables send to another place than a dense solution, as a part of all.
double misplaced(const Tables& tables, const DenseBounces& dense) {
    const Brdf brdf(std::shared_ptr<const Tables>(&tables, [](const Tables*) {}));
    double wrong = 0;
    for (std::size_t i = 0; i < dense.k.size(); ++i)
        for (std::size_t j = 0; j < dense.k.size(); ++j) {
            const double rho = brdf.evaluate(dense.k[i], dense.k[j], Term::multibounce).x;
            wrong += dense.weight[i] * dense.weight[j] * std::fabs(dense.more(i, j) - rho);
        }
    return wrong / pi;
}

std::vector<Design> many() {
    if (cheap) return {of(UniformLobe{}), grooves(0.2)};
    std::vector<Design> all{of(UniformLobe{}), of(GgxLobe{0.25, 1}), of(InverseGaussianLobe{0.5}),
                            grooves(0.2)};
    Design tilted = of(GaussianLobe{0.4, 0.2});
    tilted.distribution.layers[0].tilt = 30;
    all.push_back(tilted);
    for (const MaskingModel& masking :
         {MaskingModel{CorrelatedMasking{}}, MaskingModel{SmithCorrelatedMasking{}}}) {
        Design design = of(GgxLobe{0.3, 0.6});
        design.shadowing.model = masking;
        all.push_back(design);
    }
    return all;
}

}  // namespace

TEST_CASE(
    "a white furnace closes: on the interpolants to rounding, by a quadrature of the BRDF within R's claim") {
    for (Design design : many())
        for (const Multibounce& bounces :
             {Multibounce{RankOneMultibounce{}}, Multibounce{MomentumMultibounce{}}}) {
            design.multibounce = bounces;
            const auto tables = bake(design);
            CAPTURE(kind_name(design.distribution.layers[0].lobe));
            CAPTURE(kind_name(bounces));
            double interpolants = 0;
            Random random(7);
            for (int i = 0; i < 200; ++i) {
                const dvec3 k = random_direction(random);
                const dvec3 whole = tables->shading.total_albedo(tables->shading.direction(k));
                interpolants = std::max(interpolants, std::fabs(whole.x - 1));
            }
            CHECK(interpolants <= 1e-6);
            CHECK(measure_bounces(*tables, {}).furnace <= std::max(tables->errors.albedo.worst, 1e-3));
        }
}

TEST_CASE("multiple bounces: reciprocity to the last bit, of every symmetry and sent back") {
    for (Design design : many()) {
        design.fresnel = SchlickFresnel{{0.95, 0.6, 0.3}};
        for (const double retro : {0.0, 0.4}) {
            design.retro.weight = retro;
            check_reciprocity(bake(design));
        }
        if (cheap) return;
    }
}

TEST_CASE("grooves and brushed metal send their later bounces where a dense solution does") {
    for (const auto& [design, even] :
         {std::pair{of(GgxLobe{0.25, 1}), 0.25}, std::pair{grooves(0.283), 0.25}}) {
        const auto tables = bake(design);
        const DenseBounces dense = dense_bounces(*tables->distribution, 400);
        const double fitted = misplaced(*tables, dense);
        CHECK(fitted <= 0.035);
        CHECK(*tables->bounces->misplaced <= 0.035);
        Design flat = design;
        flat.multibounce = RankOneMultibounce{};
        CHECK(misplaced(*bake(flat), dense) > even);
    }
}

// With Schlick's Fresnel, an exact one, a tint and tints that differ. A mean factor of each end does not know
// that the second facet in a groove is the other side's: tints that differ there are up to 0.08 off.
TEST_CASE("the albedo of bounces is that of walks, each colour") {
    std::vector<Design> designs;
    Design gold = of(GgxLobe{0.5, 0.5});
    gold.fresnel = SchlickFresnel{{0.95, 0.6, 0.3}};
    designs.push_back(gold);
    gold.fresnel = MeasuredFresnel{};
    designs.push_back(gold);
    gold.distribution.layers[0].lobe = GgxLobe{0.25, 1};
    gold.distribution.layers[0].tint = {0.9, 0.5, 0.3};
    designs.push_back(gold);
    Design two = grooves(0.3);
    two.fresnel = SchlickFresnel{{0.9, 0.8, 0.7}};
    two.distribution.layers[0].tint = {0.9, 0.3, 0.5};
    two.distribution.layers[1].tint = {0.4, 0.8, 0.5};
    designs.push_back(two);
    if (cheap) designs.erase(designs.begin() + 1, designs.end());
    for (Design design : designs)
        for (const Multibounce& bounces :
             {Multibounce{RankOneMultibounce{}}, Multibounce{MomentumMultibounce{}}}) {
            design.multibounce = bounces;
            const auto tables = bake(design);
            const Reference reference(design);
            const BounceOracle oracle(reference);
            for (const dvec3 k : {polar(0.98, 0.3), polar(0.6, 1.2), polar(0.25, 2.5)}) {
                const dvec3 read = tables->shading.direction(k).M;
                const WalkEstimate walked = oracle.albedo(k, {.walks = 16384});
                const double most = tint_of(design.distribution) == Tint::varied ? 0.08 : 0.02;
                CAPTURE(kind_name(design.fresnel));
                CAPTURE(kind_name(design.distribution.layers[0].lobe));
                CAPTURE(kind_name(bounces));
                for (int c = 0; c < 3; ++c) {
                    CAPTURE(read[c]);
                    CHECK(std::fabs(read[c] - walked.mean[c]) <= most);
                }
            }
        }
}

TEST_CASE(
    "what bounces bring is the integral of the term, and the coupled term takes what all specular light "
    "leaves") {
    Design design = of(GgxLobe{0.4, 0.7});
    design.fresnel = SchlickFresnel{{0.9, 0.5, 0.2}};
    design.diffuse = CoupledDiffuse{dvec3{1}};
    const Brdf brdf(bake(design));
    for (const dvec3 k : {polar(0.9, 0.5), polar(0.4, 2)}) {
        const auto a = brdf.tables().shading.direction(k);
        dvec3 bounces{0};
        constexpr int polar_steps = 200, azimuths = 200;
        for (int i = 0; i < polar_steps; ++i)
            for (int j = 0; j < azimuths; ++j) {
                const double r2 = (i + 0.5) / polar_steps;
                const dvec3 other = polar(std::sqrt(1 - r2), 2 * pi * (j + 0.5) / azimuths);
                bounces += brdf.evaluate(k, other, Term::multibounce) * (pi / (polar_steps * azimuths));
            }
        for (int c = 0; c < 3; ++c) CHECK(bounces[c] == doctest::Approx(a.M[c]).epsilon(2e-3));
        CHECK(brdf.tables().shading.total_albedo(a).x == doctest::Approx(1).epsilon(1e-6));
        CHECK(brdf.tables().shading.total_albedo(a).z == doctest::Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("samples of a design with bounces weigh what they should, and checks pass") {
    const std::vector<Design> checked{of(GgxLobe{0.25, 1}), grooves(0.3)};
    for (std::size_t i = 0; i < (cheap ? 1 : checked.size()); ++i) {
        const Design& design = checked[i];
        CAPTURE(kind_name(design.distribution.layers[0].lobe));
        const PhysicsReport report = check_physics(design);
        for (const PhysicsCheck& check : report.checks) {
            CAPTURE(check.name);
            CAPTURE(check.figure);
            CHECK(check.verdict != Verdict::fail);
        }
    }
}

TEST_CASE(
    "bounces are written when there are any, as version 2, and refused where R is not known to be a share") {
    Design design = of(GgxLobe{0.3, 0.3}, NoMultibounce{});
    CHECK(design_json(design, {}).find("multibounce") == std::string::npos);
    design.multibounce = MomentumMultibounce{};
    const std::string text = design_json(design, {});
    CHECK(text.find("\"nacre\": 2") != std::string::npos);
    CHECK(parse_design(text, "test.nacre", "/") == design);
    Design open = design;
    open.shadowing.clamp = false;
    CHECK(user_error_of([&] { check_design(open, "test.nacre"); }).find("multibounce.model") !=
          std::string::npos);
    design.diffuse = MetalDiffuse{};
    CHECK(user_error_of([&] { check_design(design, "test.nacre"); }).find("metal") != std::string::npos);
}

TEST_CASE("a draft spreads light evenly, and a new f0 keeps what was fitted") {
    Design design = of(GgxLobe{0.3, 0.6});
    design.fresnel = SchlickFresnel{{0.9, 0.5, 0.2}};
    Baker baker;
    CHECK_FALSE(baker.bake(design, {.quality = Quality::draft})->bounces->fitted);
    CHECK_FALSE(baker.bake(design, {.fit_bounces = false})->bounces->fitted);
    const auto first = baker.bake(design);
    CHECK(first->bounces->fitted);
    design.fresnel = SchlickFresnel{{0.3, 0.5, 0.9}};
    const auto second = baker.bake(design);
    CHECK(second->data == bake(design)->data);
    CHECK(second->shading.surface.bounce_scale == bake(design)->shading.surface.bounce_scale);
}
