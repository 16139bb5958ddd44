#include "core/formats/distribution_json.h"

#include "core/formats/json_numbers.h"
#include "core/formats/table_manifest.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;
using Shader = Shading<double>;

// `lobe` is what the layer was made of; (i, j) in its formula is inverse_width.
Json layer_json(const Tables& tables, int index, const Lobe& lobe) {
    const Shader::Layer& layer = tables.shading.layers[index];
    Json json = {{"kind", std::visit([](const auto& kind) { return kind.table_kind(); }, lobe)},
                 {"lobe", std::visit([](const auto& kind) { return kind.formula(); }, lobe)},
                 {"scale", layer.scale},
                 {"axis_x", json_numbers(layer.axis_x)},
                 {"axis_y", json_numbers(layer.axis_y)},
                 {"axis_z", json_numbers(layer.axis_z)},
                 {"inverse_width", json_numbers(layer.inverse_width)}};
    if (tables.needs.tint == Tint::varied) json["tint"] = json_numbers(layer.tint);
    if (std::holds_alternative<CurveLobe>(lobe)) {
        Json curve = Json::array();
        for (int i = 0; i < layer.data_size; ++i) {
            const auto at = static_cast<std::size_t>(layer.data_offset + 2 * i);
            curve.push_back({tables.data[at], tables.data[at + 1]});
        }
        json["curve"] = std::move(curve);
    }
    if (holds_picture(lobe)) json["picture"] = layer_picture_file(index, "painted");
    if (layer.picture_size > 0) {
        json["modulation"] = layer_picture_file(index, "modulation");
        json["modulation_strength"] = layer.picture_strength;
    }
    return json;
}

// The lobes of the shader's layers, in their order.
std::vector<const Lobe*> lobes_in_use(const Distribution& distribution) {
    std::vector<const Lobe*> lobes;
    for (const Layer& layer : distribution.layers)
        if (counts(layer)) lobes.push_back(&layer.lobe);
    return lobes;
}

}  // namespace

Json distribution_json(const Design& design, const Tables& tables) {
    const std::vector<const Lobe*> lobes = lobes_in_use(design.distribution);
    Json layers = Json::array();
    for (int i = 0; i < tables.shading.layer_count; ++i)
        layers.push_back(layer_json(tables, i, *lobes.at(static_cast<std::size_t>(i))));
    Json json = {
        {"p",
         "density of facet normals h on the sphere, 1/sr, integral 1: the sum over the layers of scale * "
         "lobe"},
        {"own_frame",
         "(x, y, z) = (h.axis_x, h.axis_y, h.axis_z), (i, j) = inverse_width, angles in radians; a lobe is 0 "
         "where z <= 0 unless it says otherwise"},
        {"pictures",
         "side x side texels, the upper hemisphere seen from above: column = side (1 + x/sqrt(1+z))/2 - "
         "1/2, row = "
         "side (1 - y/sqrt(1+z))/2 - 1/2, both kept in [0, side-1], bilinear; row 0 is the first scan "
         "line; 0 "
         "where z <= 0"},
        {"modulation", "the lobe times 1 - modulation_strength + modulation_strength picture(x, y, z)"},
        {"layers", std::move(layers)}};
    if (tables.needs.tint == Tint::varied)
        json["q"] =
            "what the specular term takes in place of p, each colour: the sum over the layers of tint * "
            "scale * "
            "lobe";
    return json;
}

}  // namespace nacre
