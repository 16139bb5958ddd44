// The part of a layer that the tools paint, and what its weight becomes.
#include "core/paint/layer_paint.h"

#include <doctest/doctest.h>

#include "core/model/facet_distribution.h"
#include "core/model/lobe.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"

using namespace nacre;

namespace {

std::shared_ptr<const Raster> even(float value) {
    return std::make_shared<Raster>(Raster{
        painted_side, painted_side, std::vector<float>(std::size_t{painted_side} * painted_side, value)});
}

Distribution two_layers() {
    Distribution distribution;
    distribution.layers.resize(2);
    distribution.layers[0].lobe = GaussianLobe{0.3, 0.2};
    distribution.layers[0].modulation = open_mask();
    distribution.layers[0].weight = 0.6;
    return distribution;
}

}  // namespace

TEST_CASE("layer paint: a mask that hides nothing changes nothing of p") {
    Distribution distribution = two_layers();
    const FacetDistribution masked(distribution,
                                   [](const Layer& layer, std::size_t) { return make_lobe(layer); });
    distribution.layers[0].modulation.reset();
    const FacetDistribution bare(distribution,
                                 [](const Layer& layer, std::size_t) { return make_lobe(layer); });
    for (const dvec3 h :
         {dvec3(0, 0, 1), glm::normalize(dvec3(0.3, -0.2, 1)), glm::normalize(dvec3(-2, 0, 1))})
        CHECK(masked.density(h) == doctest::Approx(bare.density(h)).epsilon(1e-4));
}

TEST_CASE("layer paint: what a mask hides is taken from the layer's weight, and given back") {
    Distribution distribution = two_layers();
    std::size_t chosen = 0;
    const auto paint = LayerPaint::open(distribution, chosen, LayerPart::mask);
    REQUIRE(paint);
    CHECK(distribution == two_layers());
    CHECK(paint->with(even(0.25f)).weight == doctest::Approx(0.15));
    auto half = std::make_shared<Raster>(*even(1));
    for (std::size_t i = 0; i < half->values.size(); ++i)
        if (i % painted_side < painted_side / 2) half->values[i] = 0;
    CHECK(paint->with(half).weight == doctest::Approx(0.3));
    const Layer none = paint->with(even(0));
    CHECK(!none.enabled);
    CHECK(none.weight == 0.6);
    distribution.layers[0] = none;
    const auto again = LayerPaint::open(distribution, chosen, LayerPart::mask);
    const Layer back = again->with(even(0.5f));
    CHECK(back.enabled);
    CHECK(back.weight == 0.6);
}

TEST_CASE("layer paint: a faint mask leaves room for what it may show") {
    Distribution distribution = two_layers();
    distribution.layers[0].weight = limits::weight_max;
    distribution.layers[0].modulation->image.raster = even(0.01f);
    const double share = distribution.layers[1].weight / distribution.layers[0].weight;
    std::size_t chosen = 0;
    const auto paint = LayerPaint::open(distribution, chosen, LayerPart::mask);
    CHECK(distribution.layers[1].weight / distribution.layers[0].weight == doctest::Approx(share));
    CHECK(paint->with(even(1)).weight <= limits::weight_max);
}

TEST_CASE("layer paint: only a painted lobe is begun anew where there is none") {
    Distribution distribution = two_layers();
    std::size_t chosen = 1;
    CHECK(!LayerPaint::open(distribution, chosen, LayerPart::mask));
    CHECK(distribution.layers.size() == 2);
    const auto paint = LayerPaint::open(distribution, chosen, LayerPart::lobe);
    REQUIRE(paint);
    CHECK(chosen == 2);
    CHECK(!distribution.layers[2].enabled);
    CHECK(paint->with(even(0.5f)).enabled);
    CHECK(paint->with(even(0.5f)).weight == doctest::Approx(0.5 * 1.6));
    distribution.layers.pop_back();
    CHECK(!paint->stands_in(distribution));
}
