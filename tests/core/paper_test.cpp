// What the paper's page says: Ward's albedo in its three forms, matt facets, the energy of slanted velvet,
// the error of the paper's table, and the page itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/bake/bake.h"
#include "core/compare/facet_slopes.h"
#include "core/model/polar_angles.h"
#include "core/study/excess_energy.h"
#include "core/study/oren_nayar_fit.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_grid.h"
#include "core/study/paper_page.h"
#include "core/study/ward.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/well_formed.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

constexpr WardForm ward_forms[] = {WardForm::published, WardForm::corrected, WardForm::bounded};

// R by a plain sum over k2.
double plain_albedo(WardForm which, const Shading<double>::ClosedForm& form, dvec3 k1) {
    constexpr int rings = 600, spokes = 600;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j) {
            const double c = (i + 0.5) / rings, phi = 2 * pi * (j + 0.5) / spokes, s = std::sqrt(1 - c * c);
            sum += c * ward_brdf(which, form, k1, {s * std::cos(phi), s * std::sin(phi), c});
        }
    return sum * 2 * pi / (rings * spokes);
}

class NoRenderer final : public PaperRenderer {
  public:
    PaperImage draw(const ComparedSurface& surface, const PaperView&, glm::ivec2 size) override {
        CHECK(surface.tables != nullptr);
        return {size, std::vector<float>(static_cast<std::size_t>(3 * size.x * size.y), 0.5f)};
    }
    float shown(double radiance) const override { return static_cast<float>(std::min(radiance, 1.0)); }
};

const PaperPart& part(std::string_view name) {
    for (const PaperPart* each : paper_parts())
        if (each->name == name) return *each;
    throw std::logic_error("no such part");
}

}  // namespace

TEST_SUITE_BEGIN("paper");

TEST_CASE("Ward's albedo is the integral of his BRDF, in every form") {
    const auto form = ward_form({0.4, 0.6});
    for (const WardForm which : ward_forms)
        for (const double theta : {0.0, 40.0, 75.0})
            CHECK(ward_albedo(which, form, polar_direction(theta, 30)) ==
                  doctest::Approx(plain_albedo(which, form, polar_direction(theta, 30))).epsilon(3e-3));
}

TEST_CASE("Ward's forms agree at the normal of a narrow lobe and part toward grazing") {
    const auto form = ward_form({0.01, 0.02});
    for (const WardForm which : ward_forms)
        CHECK(ward_albedo(which, form, {0, 0, 1}) == doctest::Approx(1).epsilon(2e-3));
    for (const double phi : {0.0, 90.0})
        for (const double theta : {20.0, 50.0, 70.0}) {
            const dvec3 k = polar_direction(theta, phi);
            // As published it falls as the cosine; 1/(c1 c2) makes up for that.
            CHECK(ward_albedo(WardForm::published, form, k) == doctest::Approx(k.z).epsilon(0.02));
            CHECK(ward_albedo(WardForm::corrected, form, k) == doctest::Approx(1).epsilon(0.02));
        }
}

TEST_CASE("at grazing Ward's albedo has no bound as published and corrected, and one as bounded") {
    const auto form = ward_form({0.1, 0.2});
    const auto at = [&](WardForm which, double degrees_left) {
        return ward_albedo(which, form, polar_direction(90 - degrees_left, 0));
    };
    for (const double left : {60.0, 20.0, 5.0, 1.0, 0.1, 1e-3, 1e-6}) {
        CHECK(at(WardForm::bounded, left) < 1);
        CHECK(at(WardForm::published, left) < at(WardForm::corrected, left));
    }
    CHECK(at(WardForm::corrected, 1) > 1);
    // As 1/sqrt(c) and as 1/c.
    CHECK(at(WardForm::published, 1e-8) / at(WardForm::published, 1e-6) == doctest::Approx(10).epsilon(0.01));
    CHECK(at(WardForm::corrected, 1e-8) / at(WardForm::corrected, 1e-6) ==
          doctest::Approx(100).epsilon(0.01));
    CHECK(at(WardForm::published, 1e-8) > 1);
}

TEST_CASE("Ward's BRDF is reciprocal in every form") {
    const auto form = ward_form({0.1, 0.4});
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const dvec3 k1 = cosine_sample(random), k2 = cosine_sample(random);
        for (const WardForm which : ward_forms)
            CHECK(ward_brdf(which, form, k1, k2) == ward_brdf(which, form, k2, k1));
    }
}

TEST_CASE("Oren and Nayar's sigma of a narrow Gaussian is its width over the root of 2") {
    const auto sigma_of = [](const Lobe& lobe) {
        return oren_nayar_sigma(FacetDistribution(design_of(lobe).distribution));
    };
    CHECK(sigma_of(GaussianLobe{0.02, 0.02}) == doctest::Approx(0.02 / std::sqrt(2)).epsilon(1e-2));
    // A wide one has fewer steep facets than that.
    CHECK(sigma_of(GaussianLobe{1, 1}) == doctest::Approx(23.9 * pi / 180).epsilon(5e-3));
    // Of the uniform hemisphere: <theta^2> = pi - 2.
    CHECK(sigma_of(UniformLobe{}) == doctest::Approx(std::sqrt(0.5 * (pi - 2))).epsilon(1e-3));
}

TEST_CASE(
    "the sigma by the rule is within a degree of the one that brings Oren and Nayar closest to eq. 33") {
    Design design = design_of(GaussianLobe{1, 1});
    design.diffuse = FacetDiffuse{.kd = 1, .ks = 0, .albedo = glm::dvec3{1}};
    const auto tables = bake(design);
    const Shading<double>& shading = tables->shading;
    const double closest = closest_sigma([&](dvec3 k1, dvec3 k2) {
        return shading.facet_visibility(shading.direction(k1), shading.direction(k2), shading.facet_spot(k1),
                                        shading.facet_spot(k2)) /
               pi;
    });
    CAPTURE(closest * 180 / pi);
    CHECK(std::fabs(oren_nayar_sigma(*tables->distribution) - closest) <= pi / 180);
}

TEST_CASE("slanted velvet creates energy in the paper's 14 of 200 directions, and in none with P at most 1") {
    const auto excess_of = [](const SlantedMirrors& how, int polar) {
        return excess_energy(*bake(slanted_mirrors(how)), polar, 200 / polar, {});
    };
    // The paper's points are not known.
    for (const int polar : {10, 20}) CHECK(std::abs(excess_of({}, polar).directions - 14) <= 2);
    CHECK(excess_of({.lean = 40}, 20).directions > 28);
    // Under t = 0 R is as N; under t = 1 it is the same in part.
    const ExcessEnergy published = excess_of({}, 20), plain = excess_of({.mean_cosine_scale = 1}, 20);
    CHECK(plain.directions < published.directions);
    CHECK(plain.largest < published.largest);
    CHECK(plain.largest > 0.5 * published.largest);
    const ExcessEnergy clamped = excess_of({.clamp = true}, 20);
    CHECK(clamped.directions == 0);
    CHECK(clamped.largest <= 1);
}

TEST_CASE("200 points err by more the narrower p is; the stretched tables do not") {
    double before = 0;
    for (const double narrow : {0.3, 0.1, 0.01, 0.001}) {
        const auto tables = bake(paper_gaussian(narrow, 1));
        const auto of = [&](PaperPoints points) {
            return worst_error(*tables, paper_table(*tables->distribution, points, {}), {}).error;
        };
        const double kindest = of(PaperPoints::polar_20_quarter);
        CHECK(kindest > before);
        for (const PaperPoints points : {PaperPoints::polar_10_quarter, PaperPoints::polar_10_hemisphere})
            CHECK(of(points) > 0.02);
        CHECK(worst_error(*tables, {}).error < 2e-3);
        before = kindest;
    }
    CHECK(before > 0.2);
}

TEST_CASE("the parts of the paper have names and files of their own, and tables that are whole") {
    NoRenderer renderer;
    Baker baker;
    std::vector<MadePart> made;
    std::set<std::string> names, files;
    for (const PaperPart* each : paper_parts()) CHECK(names.insert(each->name).second);
    for (const char* name : {"figure-5", "figure-7", "figure-8", "figure-9", "grid"})
        made.push_back({&part(name), part(name).make({renderer, baker, {16, 16}, {}})});
    for (const MadePart& each : made) {
        CAPTURE(each.part->name);
        CHECK(!each.result.remarks.empty());
        for (const PaperPicture& picture : each.result.pictures) {
            CHECK(picture.file.starts_with(each.part->name));
            CHECK(files.insert(picture.file).second);
            CHECK(picture.bytes.size() > 50);
        }
        for (const PaperTable& table : each.result.tables)
            for (const auto& row : table.rows) CHECK(row.size() == table.head.size());
    }
    const std::string page = paper_page(made);
    for (const std::string& file : files) CHECK(page.find("src=\"" + file + "\"") != std::string::npos);
    for (const MadePart& each : made)
        CHECK(page.find("id=\"" + std::string(each.part->name) + "\"") != std::string::npos);
}

TEST_CASE("the page escapes what a text holds") {
    const PaperPart odd{"odd", "a < b & c", "sec. 1", "\"x\" <y>", nullptr};
    const std::string page = paper_page({{&odd, {{}, {{{"p & q"}, {{"1 < 2"}}}}, {"<b>"}}}});
    for (const char* text : {"a &lt; b &amp; c", "&lt;y&gt;", "p &amp; q", "1 &lt; 2", "&lt;b&gt;"})
        CHECK(page.find(text) != std::string::npos);
    CHECK(page.find("<b>") == std::string::npos);
}

TEST_SUITE_END();
