// Visible facets by rejection: what they are drawn from lies above p, and they are the ones that the slow,
// exact samplers draw.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/model/patch_tree.h"
#include "core/model/visible_facets.h"
#include "core/model/visible_sampler.h"
#include "tests/core/big_design.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Picture noise(int side) {
    Random random(9);
    return picture_of(side, [&](double, double) { return std::pow(uniform_random(random), 8); });
}

Design modulated(Lobe lobe, Picture picture, double strength) {
    Design design = design_of(std::move(lobe));
    design.distribution.layers[0].modulation = Modulation{std::move(picture), strength};
    return design;
}

std::vector<Design> one_lobe() {
    const auto half = [](double x, double y) { return x > 0.2 * y ? 1 : 0; };
    return {design_of(GaussianLobe{0.1, 1}),
            design_of(GaussianLobe{1e-5, limits::infinity}),
            design_of(GaussianLobe{20, 3}, 30, 20, 10),
            design_of(GgxLobe{0.01, 3}),
            design_of(BeckmannLobe{0.7, 1e-3}, 10),
            design_of(InverseGaussianLobe{0.3}),
            design_of(CurveLobe{{{5, 0}, {6, 1}, {120, 0.1}, {180, 0.3}}}),
            design_of(UniformLobe{}),
            with_layer(design_of(UniformLobe{UniformDomain::sphere}), UniformLobe{}, 1),
            design_of(PaintedLobe{noise(1)}),
            design_of(PaintedLobe{noise(24)}, 50),
            design_of(PaintedLobe{noise(64)}),
            modulated(PaintedLobe{noise(20)}, noise(7), 0.8),
            modulated(GgxLobe{0.3, 0.6}, picture_of(32, half), 1),
            modulated(BeckmannLobe{0.5, 0.5}, noise(16), 1),
            modulated(UniformLobe{UniformDomain::sphere}, picture_of(16, half), 0.9),
            modulated(CurveLobe{{{0, 1}, {150, 1}}}, noise(9), 0.5)};
}

// The sums of h and of the products of its parts, and of their squares.
class Moments {
  public:
    void add(dvec3 h) {
        const std::array<double, 6> values{h.x, h.y, h.z, h.x * h.x, h.x * h.y, h.y * h.y};
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum_[i] += values[i];
            squares_[i] += values[i] * values[i];
        }
        ++count_;
    }

    // The largest difference of two means, as a part of its standard deviation.
    double deviations_from(const Moments& other) const {
        double worst = 0;
        for (std::size_t i = 0; i < sum_.size(); ++i) {
            const double off = std::fabs(mean(i) - other.mean(i));
            const double deviation = std::sqrt(variance(i) + other.variance(i)) + 1e-12;
            worst = std::fmax(worst, off / deviation);
        }
        return worst;
    }

  private:
    double mean(std::size_t i) const { return sum_[i] / count_; }
    double variance(std::size_t i) const {
        return std::fmax(squares_[i] / count_ - mean(i) * mean(i), 0.0) / count_;
    }

    std::array<double, 6> sum_{}, squares_{};
    double count_ = 0;
};

void check_same_facets(const Design& design, dvec3 k) {
    CAPTURE(k.x);
    CAPTURE(k.z);
    constexpr int count = 4000;
    const FacetDistribution p(design.distribution);
    const VisibleSampler exact(p.lobes(), k);
    REQUIRE(exact.area() > 0);
    Random random(5);
    Moments one, many, other;
    std::vector<dvec3> drawn(count);
    p.visible_facets().draw(std::vector<dvec3>(count, k), random, drawn);
    for (int i = 0; i < count; ++i) {
        const dvec3 h = p.sample_visible(k, random);
        CHECK(glm::length(h) == doctest::Approx(1));
        CHECK(glm::dot(h, k) > 0);
        one.add(h);
        many.add(drawn[static_cast<std::size_t>(i)]);
        other.add(exact(random));
    }
    CHECK(one.deviations_from(other) < 5);
    CHECK(many.deviations_from(other) < 5);
}

}  // namespace

TEST_SUITE_BEGIN("visible facets");

TEST_CASE(
    "every lobe's patches hold it: nothing is outside a patch or above its envelope, nothing is missing") {
    int lobe = 0;
    for (const Design& design : one_lobe()) {
        ++lobe;
        CAPTURE(lobe);
        const auto model = make_lobe(design.distribution.layers[0]);
        const auto envelope = model->envelope();
        REQUIRE(envelope);
        const std::vector<FacetPatch> patches = split_envelope(*envelope, 300);
        CHECK(patches.size() <= 300);
        Random random(2);
        double mass = 0, variance = 0, largest = 0, farthest = 0;
        constexpr int draws = 200;
        for (const FacetPatch& patch : patches) {
            double sum = 0, squares = 0;
            for (int i = 0; i < draws; ++i) {
                const LobeEnvelope::Draw drawn = envelope->draw(patch, random);
                sum += drawn.part / draws;
                squares += drawn.part * drawn.part / draws;
                largest = std::fmax(largest, drawn.part);
                if (drawn.part > 0)
                    farthest = std::fmax(farthest, glm::length(drawn.h - patch.centre) - patch.radius);
            }
            mass += patch.mass * sum;
            variance += patch.mass * patch.mass * (squares - sum * sum) / draws;
        }
        CHECK(largest <= 1 + 1e-9);
        CHECK(farthest <= 1e-9);
        // A modulated lobe's own mass is a sum over cells.
        CHECK(std::fabs(mass / model->mass() - 1) < 5 * std::sqrt(variance) / model->mass() + 1e-4);
    }
}

TEST_CASE("as many facets are drawn as are seen, or some more") {
    Random random(3);
    int lobe = 0;
    for (const Design& design : one_lobe()) {
        ++lobe;
        CAPTURE(lobe);
        const FacetDistribution p(design.distribution);
        for (int i = 0; i < 100; ++i) {
            const dvec3 k = random_direction(random);
            CHECK(p.visible_facets().bound(k) >= p.projected_area(k) * (1 - 1e-5));
        }
        const dvec3 k{0, 0, 1};
        CHECK(p.visible_facets().bound(k) < 3 * p.projected_area(k));
    }
    for (const int side : {32, 128, 512}) {
        const FacetDistribution p(design_of(PaintedLobe{noise(side)}).distribution);
        const dvec3 k = polar(0.2, 1);
        CHECK(p.visible_facets().bound(k) < 1.5 * p.projected_area(k));
    }
}

TEST_CASE("facets are those that the exact samplers draw") {
    int lobe = 0;
    for (const Design& design : one_lobe()) {
        ++lobe;
        CAPTURE(lobe);
        for (const dvec3 k : {polar(0.9, 0.4), polar(0.3, 2), polar(0.02, 4)}) check_same_facets(design, k);
    }
}

TEST_CASE("facets of many layers, and of those that have all but turned away, are those too") {
    Design mixture = with_layer(design_of(GgxLobe{0.1, 0.2}, 20), BeckmannLobe{0.05, 0.05}, 2, 30, 90);
    mixture = with_layer(std::move(mixture), GaussianLobe{0.02, 0.7}, 0.5, 60, 200);
    check_same_facets(mixture, polar(0.5, 3.4));
    check_same_facets(mixture, polar(0.01, 0.1));
    check_same_facets(big_design(5, 32), polar(0.1, 1));
    for (const double tilt : {50, 70}) {
        check_same_facets(design_of(GaussianLobe{0.2, 0.2}, tilt), polar(0.05, 3.14));
        check_same_facets(design_of(BeckmannLobe{0.2, 0.2}, tilt), polar(0.05, 3));
        check_same_facets(
            design_of(PaintedLobe{picture_of(
                          16, [](double x, double y) { return std::exp(-60 * (x * x + y * y)); })},
                      tilt),
            polar(0.1, 3));
    }
}

TEST_CASE("where no facet is seen none is drawn") {
    const FacetDistribution p(design_of(PaintedLobe{picture_of(64, [](double x, double y) {
                                  return x > 0.4 && y * y < 0.01;
                              })}).distribution);
    const dvec3 k = polar(0.1, 3.14159);
    REQUIRE(p.projected_area(k) == 0);
    Random random(1);
    CHECK_FALSE(p.visible_facets()(k, random));
    std::array<dvec3, 3> drawn;
    p.visible_facets().draw(std::array<dvec3, 3>{k, dvec3{0, 0, 1}, k}, random, drawn);
    CHECK(drawn[0] == dvec3{0});
    CHECK(glm::length(drawn[1]) == doctest::Approx(1));
    CHECK(drawn[2] == dvec3{0});
}

TEST_CASE("patches are drawn by what k may see of them, and no less than that of all of them") {
    Random random(4);
    for (const int count : {1, 16, 17, 300}) {
        CAPTURE(count);
        std::vector<PatchBall> patches;
        for (int i = 0; i < count; ++i) {
            const double mass = std::pow(uniform_random(random), 4) / count;
            patches.push_back({random_direction(random), 0.1 * uniform_random(random), mass});
        }
        const PatchTree tree(patches);
        const dvec3 k = glm::normalize(patches[0].centre + dvec3{0.8, 0.1, -0.1});
        const PatchView view = tree.view(k);
        std::vector<int> drawn(patches.size());
        constexpr int draws = 200000;
        double mean = 0, most = 0;
        for (int i = 0; i < draws; ++i) {
            PatchDescent descent{&view, uniform_random(random) * view.all, 0};
            tree.descend({&descent, 1});
            if (descent.leaf == PatchTree::none) continue;
            const std::size_t patch = tree.order()[descent.leaf];
            const double share = patches[patch].mass *
                                 (std::fmax(glm::dot(patches[patch].centre, k), 0.0) + patches[patch].radius);
            most = std::fmax(most, descent.left / share);
            mean += descent.left / share / draws;
            ++drawn[patch];
        }
        CHECK(most < 1 + 1e-4);
        double all = 0, found = 0;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const double across = glm::dot(patches[i].centre, k) + patches[i].radius;
            const double share =
                across > 0
                    ? patches[i].mass * (std::fmax(glm::dot(patches[i].centre, k), 0.0) + patches[i].radius)
                    : 0;
            const double expected = draws * share / view.all;
            CHECK(std::fabs(drawn[i] - expected) <= 6 * std::sqrt(expected) + 1e-4 * draws / count);
            all += share;
            found += drawn[i];
        }
        CHECK(view.all >= all * (1 - 1e-6));
        if (found > 0) CHECK(mean * draws / found == doctest::Approx(0.5).epsilon(0.02));
    }
}

TEST_SUITE_END();
