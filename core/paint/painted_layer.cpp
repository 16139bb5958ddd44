#include "core/paint/painted_layer.h"

#include <algorithm>
#include <cmath>

#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

// Fainter than any brush leaves it.
constexpr float faint = 1e-3f;

std::shared_ptr<const Raster> in_paint_unit(const std::shared_ptr<const Raster>& given) {
    const auto largest = static_cast<float>(paint_unit(*given));
    if (largest == 1) return given;
    auto scaled = std::make_shared<Raster>(*given);
    for (float& value : scaled->values) value = std::min(value / largest, 1.0f);
    return scaled;
}

}  // namespace

std::shared_ptr<const Raster> blank_raster() {
    const auto texels = std::size_t{painted_side} * painted_side;
    return std::make_shared<const Raster>(
        Raster{painted_side, painted_side, std::vector<float>(texels, 0.0f)});
}

Layer blank_painted_layer() {
    Layer layer;
    layer.lobe = PaintedLobe{{{}, blank_raster()}};
    layer.enabled = false;
    return layer;
}

double paint_unit(const Raster& picture) {
    const float largest = largest_on_disk(picture);
    const bool in_unit = !(largest > 0) || (largest >= faint && largest <= 1);
    return in_unit ? 1 : static_cast<double>(largest);
}

std::shared_ptr<const Raster> paintable(const PaintedLobe& lobe) { return paintable(lobe.image.raster); }

std::shared_ptr<const Raster> paintable(const std::shared_ptr<const Raster>& picture) {
    std::shared_ptr<const Raster> given = in_paint_unit(picture);
    if (given->width >= painted_side) return given;
    auto finer = std::make_shared<Raster>();
    finer->width = finer->height = painted_side;
    finer->values.reserve(std::size_t{painted_side} * painted_side);
    const Raster read = extended_past_rim(*given);
    // Beyond the outermost middles a picture keeps their values, as shaders read it.
    const double inside = 1 - 1.0 / given->width;
    for (int row = 0; row < painted_side; ++row)
        for (int column = 0; column < painted_side; ++column) {
            const glm::dvec2 at = texel_point(painted_side, row, column);
            finer->values.push_back(
                static_cast<float>(raster_value(read.values, given->width, glm::clamp(at, -inside, inside))));
        }
    return finer;
}

dvec3 above_horizon(dvec3 h) {
    if (h.z >= 0) return h;
    const double sine = std::hypot(h.x, h.y);
    return sine > 0 ? dvec3(h.x / sine, h.y / sine, 0) : dvec3(1, 0, 0);
}

void set_raster(Layer& layer, std::shared_ptr<const Raster> raster, double mass, double first_weight) {
    weigh_by_paint(layer, mass, raster_mass(*raster), first_weight);
    std::get<PaintedLobe>(layer.lobe).image = {{}, std::move(raster)};
    layer.source.reset();
}

void weigh_by_paint(Layer& layer, double mass, double after, double first_weight) {
    if (after > 0) {
        layer.weight = mass > 0 ? layer.weight * (after / mass) : first_weight;
        if (!(mass > 0)) layer.enabled = true;
    } else {
        layer.enabled = false;
    }
}

void make_room_for_paint(Distribution& distribution, std::size_t layer, double mass, double mass_max) {
    const double room = limits::weight_max * std::min(mass / mass_max, 1.0);
    const double weight = distribution.layers[layer].weight;
    if (!(mass > 0) || weight <= room) return;
    for (Layer& each : distribution.layers) each.weight *= room / weight;
}

double weight_of_others(const Distribution& distribution, std::size_t except) {
    double sum = 0;
    for (std::size_t i = 0; i < distribution.layers.size(); ++i)
        if (i != except && distribution.layers[i].enabled) sum += distribution.layers[i].weight;
    return sum;
}

}  // namespace nacre
