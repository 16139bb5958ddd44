// What a picture is near the rim of its disk, and that the rest of its square is nothing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/bake/bake.h"
#include "core/model/disk_texels.h"
#include "core/model/facet_distribution.h"
#include "core/model/quadrature.h"
#include "core/verify/facet_integral.h"
#include "core/verify/reference.h"
#include "tests/core/big_design.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using nacre::test::random_direction;

namespace {

using std::numbers::pi;

// `roughness`: the power of a uniform random number.
Picture noise(int side, double roughness, Random& random) {
    Raster raster{side, side, {}};
    for (int i = 0; i < side * side; ++i)
        raster.values.push_back(static_cast<float>(std::pow(uniform_random(random), roughness)));
    return {{}, std::make_shared<const Raster>(raster)};
}

// Another picture that is the same on the disk.
Picture with_other_corners(const Picture& picture, Random& random) {
    auto raster = std::make_shared<Raster>(*picture.raster);
    const int side = raster->width;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            if (!on_disk(side, row, column)) {
                const double u = uniform_random(random);
                raster->values[static_cast<std::size_t>(row * side + column)] =
                    u < 0.2 ? std::numeric_limits<float>::max() : static_cast<float>(1e9 * u);
            }
    return {{}, raster};
}

Layer painted(Picture picture) {
    Layer layer;
    layer.lobe = PaintedLobe{std::move(picture)};
    return layer;
}

Layer modulated(Lobe lobe, Picture picture, double strength) {
    Layer layer;
    layer.lobe = std::move(lobe);
    layer.modulation = Modulation{std::move(picture), strength};
    return layer;
}

void check_same(const Layer& a, const Layer& b) {
    const auto p = make_lobe(a), q = make_lobe(b);
    CHECK(p->mass() == q->mass());
    CHECK(p->mean() == q->mean());
    Random random(3), one(4), other(4);
    for (int i = 0; i < 50; ++i) {
        const dvec3 k = random_direction(random);
        CHECK(p->density(k) == q->density(k));
        CHECK(p->projected_area(k) == q->projected_area(k));
        CHECK(p->sample_visible(k, one) == q->sample_visible(k, other));
    }
    Design design, same;
    design.distribution.layers = {a};
    same.distribution.layers = {b};
    const BakeOptions draft{.quality = Quality::draft, .threads = 1};
    const auto tables = bake(design, draft), others = bake(same, draft);
    CHECK(tables->data == others->data);
    CHECK(tables->needs.symmetry.symmetry == others->needs.symmetry.symmetry);
}

// Along radii of the disk, which meet a picture's lines between middles in points, exactly between those;
// round the axis by the trapezoidal rule. visit(h, mass of p there). `scale`: the angle at which p begins to
// fall; `ks`: where (k.h)+ turns. `even_cuts`: so many pieces at
// the least, for what turns elsewhere.
template <class Visit>
void visit_along_radii(const LobeModel& lobe, int side, const std::vector<dvec3>& ks, double scale,
                       int azimuths, int even_cuts, const Visit& visit) {
    const auto at_angle = [](double theta) { return std::sqrt(1 - std::cos(theta)); };
    std::vector<double> cuts;
    for (int j = 0; j < azimuths; ++j) {
        const double phi = 2 * pi * (j + 0.5) / azimuths, c = std::cos(phi), s = std::sin(phi);
        cuts = {0, 1};
        for (int i = 0; i < side; ++i)
            for (const double slope : {c, s}) {
                const double r = (2.0 * i + 1 - side) / side / slope;
                if (r > 0 && r < 1) cuts.push_back(r);
            }
        for (double theta = 0.5 * scale; theta < 0.5 * pi; theta *= 1.25) cuts.push_back(at_angle(theta));
        for (int i = 1; i < even_cuts; ++i) cuts.push_back(static_cast<double>(i) / even_cuts);
        for (const dvec3 k : ks) {
            const double turn = std::atan2(k.z, -(k.x * c + k.y * s));
            const double theta = turn < 0 ? turn + pi : turn;
            if (theta < 0.5 * pi) cuts.push_back(at_angle(theta));
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            for (const QuadraturePoint& point : gauss_legendre<7>()) {
                const double length = cuts[i + 1] - cuts[i], r = cuts[i] + length * point.x;
                const dvec3 h = disk_direction({r * c, r * s});
                visit(h, 2 * r * length * point.weight * 2 * pi / azimuths * lobe.density(h));
            }
    }
}

struct Sums {
    double mass = 0;
    dvec3 mean{0};
    std::vector<double> areas;  // of (k.h)+ for each k
};

Sums integrate_along_radii(const LobeModel& lobe, int side, const std::vector<dvec3>& ks, double scale,
                           int azimuths) {
    Sums sums;
    sums.areas.resize(ks.size());
    visit_along_radii(lobe, side, ks, scale, azimuths, 1, [&](dvec3 h, double mass) {
        sums.mass += mass;
        sums.mean += mass * h;
        for (std::size_t k = 0; k < ks.size(); ++k) sums.areas[k] += mass * std::max(glm::dot(ks[k], h), 0.0);
    });
    return sums;
}

std::vector<dvec3> views(Random& random) {
    std::vector<dvec3> ks = {{0, 0, 1}, {1, 0, 0}, glm::normalize(dvec3(0.3, -0.9, 0.02))};
    for (int i = 0; i < 3; ++i) ks.push_back(random_direction(random));
    ks.push_back(-ks.back());
    return ks;
}

// What is left between them, relative to the mass.
double difference(const LobeModel& lobe, const Sums& sums, const std::vector<dvec3>& ks) {
    double most = std::max(std::fabs(lobe.mass() - sums.mass), glm::length(lobe.mean() - sums.mean));
    for (std::size_t i = 0; i < ks.size(); ++i)
        most = std::max(most, std::fabs(lobe.projected_area(ks[i]) - sums.areas[i]));
    return most / sums.mass;
}

}  // namespace

TEST_CASE("texels off the disk change nothing, to the bit") {
    Random random(1);
    for (const int side : {3, 4, 5, 8, 33, 150}) {
        CAPTURE(side);
        const Picture picture = noise(side, 2, random), other = with_other_corners(picture, random);
        check_same(painted(picture), painted(other));
        check_same(modulated(GgxLobe{0.4, 0.2}, picture, 0.7), modulated(GgxLobe{0.4, 0.2}, other, 0.7));
        check_same(modulated(PaintedLobe{picture}, picture, 1), modulated(PaintedLobe{other}, other, 1));
    }
}

TEST_CASE("a picture is white up to the rim that is white on the disk") {
    Random random(2);
    for (const int side : {1, 2, 3, 4, 7, 8, 31, 64, 256, 511}) {
        CAPTURE(side);
        Raster white{side, side, std::vector<float>(static_cast<std::size_t>(side * side), 1.0F)};
        const Picture picture = with_other_corners({{}, std::make_shared<const Raster>(white)}, random);
        const auto lobe = make_lobe(painted(picture));
        CHECK(std::fabs(lobe->mass() / (2 * pi) - 1) < 1e-7);
        CHECK(std::fabs(raster_mass(*picture.raster) / (2 * pi) - 1) < 1e-7);
        CHECK(std::fabs(lobe->mean().z / pi - 1) < 1e-7);
        for (int i = 0; i < 200; ++i) {
            dvec3 h = random_direction(random);
            if (i % 4 == 0) h = glm::normalize(dvec3(h.x, h.y, 1e-6 * h.z));
            CHECK(std::fabs(lobe->density(h) - (h.z > 0 ? 1 : 0)) < 1e-6);
            // The uniform hemisphere's g.
            CHECK(std::fabs(lobe->projected_area(h) / (2 * pi) - (1 + h.z) / 4) < 5e-6);
        }
    }
}

TEST_CASE("mass, mean and g of a painted lobe are those of its density") {
    Random random(3);
    const std::vector<dvec3> ks = views(random);
    for (const int side : {1, 2, 3, 5, 8, 20, 43}) {
        CAPTURE(side);
        const auto picture = with_other_corners(noise(side, 3, random), random);
        for (const Fineness fineness : {Fineness::bake, Fineness::exact}) {
            const auto lobe = make_lobe(painted(picture), fineness);
            const Sums sums = integrate_along_radii(*lobe, side, ks, 0.5, side < 30 ? 1500 : 3000);
            CHECK(difference(*lobe, sums, ks) < 5e-6);
        }
    }
}

TEST_CASE("a picture with one texel of paint keeps g down to the width of that texel") {
    for (const int side : {8, 128, 300}) {
        CAPTURE(side);
        Raster raster{side, side, std::vector<float>(static_cast<std::size_t>(side * side), 0.0F)};
        raster.values[static_cast<std::size_t>(side / 2 * side + side / 2)] = 1;
        const auto lobe = make_lobe(painted({{}, std::make_shared<const Raster>(raster)}));
        // A tent seen along x: the mean of |x| is a third of its half-width.
        const double reach = 2.0 / side, off = (side / 2 * 2 + 1.0 - side) / side;
        CHECK(lobe->mass() == doctest::Approx(2 * reach * reach).epsilon(1e-6));
        if (side % 2 == 0) {
            const dvec3 middle = disk_direction({off, -off});
            const dvec3 k = glm::normalize(dvec3(middle.z, 0, -middle.x));
            const double slope = std::numbers::sqrt2 * reach;
            CHECK(lobe->projected_area(k) / lobe->mass() == doctest::Approx(slope / 6).epsilon(0.03));
        }
    }
}

TEST_CASE("mass, mean and g of a modulated lobe are those of its density") {
    Random random(4);
    const std::vector<dvec3> ks = views(random);
    const auto check_with = [&](const Lobe& lobe, const Picture& picture, double scale) {
        const int side = picture.raster->width;
        CAPTURE(side);
        const Layer layer = modulated(lobe, picture, 0.9);
        const auto tables = make_lobe(layer), truth = make_lobe(layer, Fineness::exact);
        const Sums sums = integrate_along_radii(*truth, side, ks, scale, 1200);
        CHECK(difference(*tables, sums, ks) < 1e-4);
        CHECK(difference(*truth, sums, ks) < 1.5e-5);
    };
    const auto check = [&](const Lobe& lobe, int side, double scale) {
        check_with(lobe, noise(side, 2, random), scale);
    };
    // Large even parts, as a painted mask has them.
    auto mask = std::make_shared<Raster>(*noise(64, 2, random).raster);
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j)
            mask->values[static_cast<std::size_t>(64 * i + j)] = j < 29 || i > 40 ? 1.0f
                                                                 : i > 20         ? 0.2f
                                                                                  : 0.6f;
    check_with(GaussianLobe{0.5, 0.5}, {{}, mask}, 0.5);
    check_with(GgxLobe{0.5, 0.05}, {{}, mask}, 0.1);
    check(GgxLobe{0.1, 0.1}, 80, 0.1);
    check(GgxLobe{0.5, 0.2}, 31, 0.2);
    check(GaussianLobe{0.5, 0.5}, 40, 0.5);
    check(PaintedLobe{noise(20, 1, random)}, 30, 0.5);
}

TEST_CASE("the exact R of a picture is the integral over its facets") {
    Random random(5);
    const auto check = [&](const Layer& layer, int side, double scale, dvec3 k) {
        Design design;
        design.distribution.layers = {layer};
        design.fresnel = SchlickFresnel{};
        const Reference reference(design);
        const PlacedLobe& placed = reference.distribution().lobes().front();
        const FacetAlbedo integrand{reference.shading(), k, reference.projected_area(k), 1};
        Values<4> sum{};
        visit_along_radii(*placed.lobe, side, {k}, scale, 240, 60, [&](dvec3 h, double mass) {
            const auto values = integrand(h, [&](dvec3 k2) { return reference.projected_area(k2); });
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += placed.scale * mass * values[c];
        });
        const AlbedoValues exact = reference.albedo(k);
        for (std::size_t c = 0; c < 2; ++c) CHECK(std::fabs(exact[c] - sum[c]) < 2e-5);
    };
    check(painted(with_other_corners(noise(6, 2, random), random)), 6, 0.5,
          glm::normalize(dvec3(0.2, 0.3, 1)));
    check(modulated(GgxLobe{0.3, 0.3}, noise(5, 1, random), 0.9), 5, 0.3,
          glm::normalize(dvec3(-0.9, 0.3, 0.1)));
}

TEST_CASE("the integrals of p by which a design is checked see texels that stand alone") {
    Random random(5);
    const Design design = test::design_of(PaintedLobe{test::random_picture(512, 2, random)}, 30);
    const FacetDistribution p(design.distribution);
    for (const double c : {0.3, 0.8}) {
        const dvec3 k{std::sqrt(1 - c * c), 0, c};
        const FacetIntegral integral = integrate_facets(design.distribution, p, k);
        CHECK(integral.whole == doctest::Approx(1).epsilon(1e-6));
        CHECK(integral.visible == doctest::Approx(p.projected_area(k)).epsilon(1e-5));
    }
}
