// Facets that are matt themselves: closed forms, the tables' errors, energy, and the walks.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/bake/baker.h"
#include "core/bake/brdf.h"
#include "core/bake/facet_tables.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/verify/facet_oracle.h"
#include "core/verify/physics_check.h"
#include "tests/core/cheap.h"
#include "tests/core/designs.h"
#include "tests/core/integrated.h"
#include "tests/core/reciprocity.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

Design matt(const Lobe& lobe, dvec3 albedo = dvec3{1}) {
    Design design = design_of(lobe);
    design.fresnel = NoFresnel{};
    design.diffuse = FacetDiffuse{.kd = 1, .ks = 0, .albedo = albedo};
    return design;
}

// A star of six arms, which has no mirror plane that the layers' parameters tell of.
Design star() {
    Design design = matt(GgxLobe{0.3, 0.3});
    design.distribution.layers[0].modulation = Modulation{picture_of(128, [](double x, double y) {
        return 0.05 + std::pow(std::fmax(std::cos(6 * std::atan2(y, x)), 0.0), 4);
    })};
    return design;
}

Design leaning() {
    Design design = matt(GaussianLobe{0.4, 0.2});
    design.distribution.layers[0].tilt = 30;
    return design;
}

// k from w and azimuth of a p of these widths at grazing, crowded toward the horizon as the tables' own.
dvec3 stretched(const Tables& tables, double u, double phi) {
    const auto& shape = tables.shading.surface.tables;
    const double w = 1 - std::pow(1 - u, 1.5);
    const dvec2 e{shape.axis.x * std::cos(phi) - shape.axis.y * std::sin(phi),
                  shape.axis.y * std::cos(phi) + shape.axis.x * std::sin(phi)};
    const double q = std::hypot(shape.stretch.x * std::cos(phi), shape.stretch.y * std::sin(phi));
    return glm::normalize(dvec3{e * w, (1 - w) * 2 * q / shape.g_normal});
}

// Of V on pairs that no bake has seen.
TableError held_out_error(const Design& design, const Tables& tables, int pairs) {
    const Reference reference(design);
    const FacetOracle oracle(reference);
    Random random(11);
    std::vector<double> errors;
    const auto next = [&] {
        const double u = uniform_random(random);
        return stretched(tables, u, 2 * pi * uniform_random(random));
    };
    for (int i = 0; i < pairs; ++i) {
        const dvec3 a = next(), b = next();
        errors.push_back(facet_error(tables.shading, a, b, oracle.product(a, b)));
    }
    return summarise(errors);
}

std::size_t facet_bytes(const Tables& tables) {
    const auto& shape = tables.shading.surface.tables;
    return sizeof(float) * static_cast<std::size_t>(shape.facet_nodes * shape.facet_rows *
                                                    (shape.facet_classes * shape.facet_terms + 1));
}

std::vector<Design> of_every_symmetry() {
    std::vector<Design> all{matt(GgxLobe{0.4, 0.4}), matt(GgxLobe{0.25, 1}), leaning()};
    if (!cheap) all.push_back(star());
    return all;
}

}  // namespace

TEST_SUITE_BEGIN("matt facets");

TEST_CASE("closed forms of the uniform hemisphere and of the sphere") {
    const Reference reference(matt(UniformLobe{}));
    const AdaptiveProduct product(reference.distribution());
    const dvec3 n{0, 0, 1};
    for (const double theta : {0.0, 0.4, 1.1, 1.5, pi / 2}) {
        const dvec3 k = polar(std::cos(theta), 0.7);
        const double with_n = (std::sin(theta) + (pi - theta) * std::cos(theta)) / (3 * pi),
                     alone = (pi - theta + std::sin(theta) * std::cos(theta)) / (3 * pi);
        CHECK(product(k, n, 1e-9) == doctest::Approx(with_n).epsilon(1e-7));
        CHECK(product(k, k, 1e-9) == doctest::Approx(alone).epsilon(1e-7));
    }
    const dvec3 grazing = polar(1e-9, 0);
    CHECK(FacetOracle(reference).product(grazing, grazing) == doctest::Approx(4 / 3.0).epsilon(1e-6));
    // Half of the facets over the whole sphere.
    Design half = design_of(UniformLobe{.domain = UniformDomain::sphere});
    half = with_layer(half, UniformLobe{}, 1);
    const FacetDistribution p(half.distribution);
    for (const double theta : {0.0, 0.5, 1.3}) {
        const double fall = std::sin(theta) + (pi - theta) * std::cos(theta);
        CHECK(AdaptiveProduct(p)(polar(std::cos(theta), 2), n, 1e-9) ==
              doctest::Approx(0.5 * fall / (6 * pi) + 0.5 * fall / (3 * pi)).epsilon(1e-7));
    }
}

// (sin d + (pi - d) cos d)/pi of what it is at d = 0, both directions on the horizon.
TEST_CASE("at grazing every isotropic p falls alike with the azimuth between both directions") {
    for (const Lobe& lobe :
         {Lobe{GgxLobe{0.2, 0.2}}, Lobe{GaussianLobe{0.7, 0.7}}, Lobe{InverseGaussianLobe{0.5}}}) {
        const Design design = matt(lobe);
        const Reference reference(design);
        const AdaptiveProduct product(reference.distribution());
        const dvec3 a{1, 0, 0};
        for (const double d : {0.3, 1.2, 2.5})
            CHECK(product(a, {std::cos(d), std::sin(d), 0}, 1e-9) / product(a, a, 1e-9) ==
                  doctest::Approx((std::sin(d) + (pi - d) * std::cos(d)) / pi).epsilon(1e-5));
    }
}

// Q(k1, k2) = k1.M k2 + k1.B(k2) + k2.B(k1) + Q(-k1, -k2).
TEST_CASE("what both see and what both do not see differ by moments of p") {
    const Design design = leaning();
    const Reference reference(design);
    const FacetDistribution& p = reference.distribution();
    const AdaptiveProduct adaptive(p);
    const auto product = [&](dvec3 k1, dvec3 k2) { return adaptive(k1, k2, 1e-9); };
    const dvec3 a = polar(0.7, 0.4), b = polar(0.3, 2);
    // (x)+ (y)+ - (-x)+ (-y)+ = (x |y| + y |x|)/2, whose odd parts are those of the products themselves.
    const double there = product(a, b) - product(-a, -b), back = product(b, a) - product(-b, -a);
    CHECK(there == doctest::Approx(back).epsilon(1e-9));
    const double crossed = product(a, -b) + product(-a, b), along = product(a, b) + product(-a, -b);
    const dvec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double moment = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            moment += a[i] * b[j] *
                      (product(axes[i], axes[j]) + product(-axes[i], -axes[j]) - product(axes[i], -axes[j]) -
                       product(-axes[i], axes[j]));
    CHECK(along - crossed == doctest::Approx(moment).epsilon(1e-6));
}

TEST_CASE("isotropic tables keep within 1e-3 in 24 KiB") {
    const std::pair<Lobe, double> wanted[] = {{GaussianLobe{1, 1}, 1e-3},
                                              {GaussianLobe{0.05, 0.05}, 1e-3},
                                              {GgxLobe{0.1, 0.1}, 2e-3},
                                              {InverseGaussianLobe{0.5}, 1e-3}};
    for (const auto& pair : wanted) {
        const Design design = matt(pair.first);
        const auto tables = bake(design);
        const TableError error = held_out_error(design, *tables, cheap ? 20 : 150);
        CAPTURE(kind_name(pair.first));
        CAPTURE(error.root_mean_square);
        CHECK(error.worst <= pair.second);
        CHECK(facet_bytes(*tables) <= 24 * 1024);
    }
}

TEST_CASE("anisotropic tables keep within 2.5e-3 in the mean square in 32 KiB, and as close as they say") {
    std::vector<Design> designs{matt(GgxLobe{0.25, 1}), matt(GaussianLobe{0.1, 1}), star(), leaning()};
    if (cheap) designs.resize(1);
    for (const Design& design : designs) {
        const auto tables = bake(design);
        const TableError error = held_out_error(design, *tables, cheap ? 20 : 150);
        CAPTURE(kind_name(design.distribution.layers[0].lobe));
        CAPTURE(error.worst);
        CAPTURE(tables->errors.facets.worst);
        CHECK(error.root_mean_square <= 2.5e-3);
        CHECK(error.worst <= 1.25 * tables->errors.facets.worst);
        CHECK(facet_bytes(*tables) <= 32 * 1024);
    }
}

TEST_CASE("matt facets: reciprocity to the last bit") {
    for (Design design : of_every_symmetry()) {
        design.diffuse = FacetDiffuse{.albedo = {0.9, 0.5, 0.2}};
        check_reciprocity(bake(design, {.quality = Quality::draft}));
    }
}

TEST_CASE("a white furnace closes: white facets send back all light") {
    for (Design design : of_every_symmetry())
        for (const MaskingModel& masking :
             {MaskingModel{UncorrelatedMasking{}}, MaskingModel{SmithCorrelatedMasking{}}}) {
            design.shadowing.model = masking;
            const Brdf brdf(bake(design));
            CAPTURE(kind_name(masking));
            CAPTURE(name_of(brdf.tables().needs.symmetry.symmetry));
            for (const dvec3 k : {polar(0.95, 0.3), polar(0.2, 4)}) {
                const auto a = brdf.tables().shading.direction(k);
                CHECK(brdf.tables().shading.total_albedo(a).x == doctest::Approx(1).epsilon(1e-6));
                CHECK(integrated(brdf, k, Term::diffuse).x == doctest::Approx(1).epsilon(3e-3));
            }
            if (cheap) return;
        }
}

TEST_CASE("the albedo of each colour is the integral of the term") {
    for (const Design& white : of_every_symmetry()) {
        Design design = white;
        design.diffuse = FacetDiffuse{.kd = 1, .ks = 0, .albedo = {0.9, 0.5, 0.1}};
        const Brdf brdf(bake(design));
        for (const dvec3 k : {polar(0.4, 2)}) {
            const dvec3 read = brdf.tables().shading.total_albedo(brdf.tables().shading.direction(k));
            CHECK(apart(integrated(brdf, k, Term::diffuse), read) < 3e-3);
        }
        if (cheap) return;
    }
}

TEST_CASE(
    "of the uniform hemisphere the first bounce brings 0.58192 of white light toward n, the second 0.45 of "
    "the rest") {
    const Design design = matt(UniformLobe{}, dvec3{0.5});
    const auto tables = bake(design);
    const Shading<double>& shading = tables->shading;
    CHECK(1 - shading.facet_rest(shading.facet_spot({0, 0, 1})) == doctest::Approx(0.58192).epsilon(1e-3));
    // a^2 e2/(1 - a (1 - e2)) at a = 1/2.
    const double scale = shading.surface.facet_scale.x, second = 2 * scale / (1 - 2 * scale);
    CHECK(second == doctest::Approx(0.45).epsilon(0.03));
}

TEST_CASE("both bounces are what walks say") {
    for (const MaskingModel& masking :
         {MaskingModel{UncorrelatedMasking{}}, MaskingModel{SmithCorrelatedMasking{}}}) {
        Design design = matt(GgxLobe{0.5, 0.5}, {0.8, 0.5, 0.2});
        design.shadowing.model = masking;
        const Brdf brdf(bake(design));
        const Reference reference(design);
        const FacetOracle oracle(reference);
        for (const auto& [a, b] :
             {std::pair{polar(0.9, 0.2), polar(0.7, 1.4)}, std::pair{polar(0.5, 0.3), polar(0.8, 3)}}) {
            const WalkEstimate walked = oracle.rho(a, b, {.walks = cheap ? 4096 : 65536, .first = 1});
            const dvec3 read = brdf.evaluate(a, b, Term::diffuse);
            for (int c = 0; c < 3; ++c) {
                CAPTURE(walked.mean[c]);
                CHECK(std::fabs(read[c] - walked.mean[c]) <= 0.03 * walked.mean[c] + 3 * walked.error[c]);
            }
        }
    }
}

TEST_CASE("the narrower p is, the more matt facets are Lambert's surface") {
    const Brdf brdf(bake(matt(GaussianLobe{0.002, 0.002}, {0.8, 0.5, 0.2})));
    for (const dvec3 k : {polar(0.9, 1), polar(0.4, 2)}) {
        const dvec3 rho = brdf.evaluate(k, polar(0.7, 0.3), Term::diffuse);
        CHECK(rho.x == doctest::Approx(0.8 / pi).epsilon(5e-3));
        CHECK(rho.z == doctest::Approx(0.2 / pi).epsilon(5e-3));
    }
}

TEST_CASE("a new colour keeps the tables, and a design without matt facets has none") {
    Baker baker;
    Design design = matt(GgxLobe{0.3, 0.5}, {0.9, 0.5, 0.1});
    const auto before = baker.bake(design);
    design.diffuse = FacetDiffuse{.kd = 0.6, .ks = 0.2, .albedo = {0.1, 0.2, 0.3}};
    const auto after = baker.bake(design);
    CHECK(after->data == before->data);
    CHECK(after->shading.surface.facet_scale.x < before->shading.surface.facet_scale.x);
    CHECK(after->errors.facets.worst == before->errors.facets.worst);
    CHECK(before->bake_seconds > 0);
    CHECK(after->bake_seconds == before->bake_seconds);
    design.diffuse = LambertianDiffuse{};
    const auto plain = baker.bake(design);
    CHECK(plain->data.size() < after->data.size());
    CHECK(plain->shading.surface.tables.facet_classes == 0);
    const std::string text = glsl_export(design, *plain);
    CHECK(text.find("facet_") == std::string::npos);
    CHECK(text.find("MATT") == std::string::npos);
}

TEST_CASE("designs with matt facets pass the checks") {
    for (Design design : {matt(GgxLobe{0.25, 1}), leaning()}) {
        design.diffuse = FacetDiffuse{.albedo = {0.9, 0.5, 0.2}};
        const PhysicsReport report = check_physics(design);
        for (const PhysicsCheck& check : report.checks) {
            CAPTURE(check.name);
            CAPTURE(check.figure);
            CAPTURE(check.bound);
            CHECK(check.verdict != Verdict::fail);
        }
        if (cheap) return;
    }
}

TEST_SUITE_END();
