#include "core/design/layer_read.h"

#include <fmt/core.h>

#include "core/design/kind_read.h"
#include "core/design/source_json.h"

namespace nacre {
namespace {

Modulation read_modulation(const JsonValue& json, const std::filesystem::path& base_dir) {
    ObjectReader reader(json);
    Modulation modulation;
    reader.number("strength", modulation.strength, {0, 1});
    const JsonValue image = reader.required("image", "a picture's path or a raster");
    reader.finish("a modulation");
    modulation.image = read_picture(image, base_dir);
    return modulation;
}

}  // namespace

Layer read_layer(const JsonValue& json, const std::filesystem::path& base_dir) {
    ObjectReader reader(json);
    Layer layer;
    layer.lobe = read_kind<Lobe>(reader, "lobe");
    reader.text("name", layer.name);
    reader.flag("enabled", layer.enabled);
    reader.number("weight", layer.weight, {0, limits::weight_max});
    reader.number("tilt", layer.tilt, {0, limits::tilt_max});
    reader.number("azimuth", layer.azimuth, {-limits::angle_max, limits::angle_max});
    reader.number("rotation", layer.rotation, {-limits::angle_max, limits::angle_max});
    reader.colour("tint", layer.tint, {0, 1});
    if (std::holds_alternative<PaintedLobe>(layer.lobe) && reader.has("source"))
        layer.source = read_source(reader.at("source"), base_dir);
    if (reader.has("modulation")) layer.modulation = read_modulation(reader.at("modulation"), base_dir);
    reader.finish(fmt::format("a layer with the lobe \"{}\"", kind_name(layer.lobe)));
    load_pictures(reader, layer.lobe, base_dir);
    return layer;
}

}  // namespace nacre
