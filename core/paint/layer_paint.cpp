#include "core/paint/layer_paint.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/model/lobe.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

constexpr double first_share = 0.5;  // weight of a blank layer's first paint, of the other layers'

// Of a layer or a constant one.
template <class AnyLayer>
auto picture_of(AnyLayer& layer, LayerPart part) -> decltype(&layer.modulation->image) {
    if (part == LayerPart::mask) return layer.modulation ? &layer.modulation->image : nullptr;
    auto* const painted = std::get_if<PaintedLobe>(&layer.lobe);
    return painted != nullptr ? &painted->image : nullptr;
}

// Of the layer as it is without its mask, at each texel of a mask.
std::vector<double> facets_under(Layer layer, int side) {
    layer.modulation.reset();
    std::vector<std::size_t> texels;
    std::vector<double> x, y, z;
    visit_texels(side, {0, 0, 1}, std::numbers::pi, [&](std::size_t index, dvec3 h) {
        if (!(h.z > 0)) return;
        texels.push_back(index);
        x.push_back(h.x), y.push_back(h.y), z.push_back(h.z);
    });
    std::vector<double> densities(texels.size());
    make_lobe(layer)->densities({x.data(), y.data(), z.data(), x.size()}, densities.data());
    std::vector<double> facets(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (std::size_t i = 0; i < texels.size(); ++i) facets[texels[i]] = densities[i];
    return facets;
}

// The same factor on p, by a picture in the unit of paint.
Modulation in_paint(const Modulation& given) {
    const double unit = paint_unit(*given.image.raster), weighted = given.strength * unit;
    Modulation modulation{{{}, paintable(given.image.raster)}, given.strength};
    if (unit != 1) modulation.strength = weighted / (1 - given.strength + weighted);
    return modulation;
}

}  // namespace

Picture* part_picture(Layer& layer, LayerPart part) { return picture_of(layer, part); }
const Picture* part_picture(const Layer& layer, LayerPart part) { return picture_of(layer, part); }

std::shared_ptr<const Raster> part_raster(const Layer& layer, LayerPart part) {
    return paintable(part_picture(layer, part)->raster);
}

Modulation open_mask() {
    auto raster = std::make_shared<Raster>(*blank_raster());
    visit_texels(raster->width, {0, 0, 1}, std::numbers::pi,
                 [&](std::size_t index, dvec3) { raster->values[index] = 1; });
    return {{{}, std::move(raster)}, 1};
}

LayerPaint::LayerPaint(std::size_t layer, LayerPart part, const Layer& given)
    : layer_(layer), part_(part), before_(given) {
    if (part == LayerPart::mask) {
        before_.modulation = in_paint(*given.modulation);
        raster_ = before_.modulation->image.raster;
        facets_ = facets_under(before_, raster_->width);
    } else {
        raster_ = part_raster(given, part);
        *part_picture(before_, part) = {{}, raster_};
    }
    mass_ = mass(*raster_);
    if (mass_ > 0) before_.enabled = true;
}

std::optional<LayerPaint> LayerPaint::open(Distribution& distribution, std::size_t& chosen, LayerPart part) {
    const auto ready = [&] {
        return chosen < distribution.layers.size() && has_part(distribution.layers[chosen], part);
    };
    if (!ready() && part == LayerPart::lobe) add_painted_layer(distribution, chosen);
    if (!ready()) return {};
    LayerPaint paint(chosen, part, distribution.layers[chosen]);
    distribution.layers[chosen] = paint.before_;
    make_room_for_paint(distribution, chosen, paint.mass_, paint.mass_max());
    paint.before_ = distribution.layers[chosen];
    const double others = weight_of_others(distribution, chosen);
    if (part == LayerPart::mask)
        paint.first_weight_ = paint.before_.weight;
    else if (others > 0)
        paint.first_weight_ = first_share * others;
    return paint;
}

bool LayerPaint::stands_in(const Distribution& distribution) const {
    return layer_ < distribution.layers.size() && has_part(distribution.layers[layer_], part_);
}

double LayerPaint::mass(const Raster& raster) const {
    if (part_ == LayerPart::lobe) return raster_mass(raster);
    const double strength = before_.modulation->strength;
    double sum = 0;
    for (std::size_t i = 0; i < facets_.size(); ++i)
        sum += facets_[i] * (1 - strength + strength * static_cast<double>(raster.values[i]));
    return sum;
}

double LayerPaint::mass_max() const {
    // Values are at most 1, and texels count in whole: a little more than the hemisphere.
    if (part_ == LayerPart::lobe) return 2.01 * std::numbers::pi;
    return std::accumulate(facets_.begin(), facets_.end(), 0.0);
}

Layer LayerPaint::with(std::shared_ptr<const Raster> raster) const {
    Layer layer = before_;
    const double after = mass(*raster);
    *part_picture(layer, part_) = {{}, std::move(raster)};
    if (part_ == LayerPart::lobe) layer.source.reset();
    weigh_by_paint(layer, mass_, after, first_weight_);
    return layer;
}

void add_painted_layer(Distribution& distribution, std::size_t& chosen) {
    auto& layers = distribution.layers;
    if (layers.size() >= limits::layers_max) return;
    const std::size_t at = std::min(chosen + 1, layers.size());
    layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(at), blank_painted_layer());
    chosen = at;
}

}  // namespace nacre
