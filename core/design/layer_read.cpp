#include "core/design/layer_read.h"

#include <fmt/core.h>

#include "core/design/design_names.h"
#include "core/exchange/picture.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr Range width_range{limits::width_min, limits::width_max};

Raster read_raster(const JsonValue& json) {
    ObjectReader reader(json);
    Raster raster;
    raster.width =
        reader.required("width", "the raster's side in pixels").whole_number(1, limits::raster_max);
    const JsonValue height = reader.required("height", "the raster's side in pixels");
    raster.height = height.whole_number(1, limits::raster_max);
    if (raster.height != raster.width)
        height.fail(fmt::format("must equal the width, {}: a raster is square", raster.width));
    const JsonValue values = reader.required("values", "the pixels row by row, the top row first");
    reader.finish("a raster");
    raster.values = values.floats(std::size_t(raster.width) * std::size_t(raster.height));
    return raster;
}

Picture read_picture(const JsonValue& json, const fs::path& base_dir) {
    if (json.is_object()) return {{}, std::make_shared<const Raster>(read_raster(json))};
    const std::string expected =
        "must be the path of a picture, or a raster {\"width\", \"height\", \"values\"}";
    if (!json.is_text()) json.fail(expected);
    const std::string path = json.text();
    if (path.empty() || path.find('\0') != path.npos) json.fail(expected);
    Picture picture{(base_dir / path).lexically_normal(), {}};
    picture.raster = load_shared_picture(picture.file, json.file(), json.path(), picture.notes);
    return picture;
}

Modulation read_modulation(const JsonValue& json, const fs::path& base_dir) {
    ObjectReader reader(json);
    Modulation modulation;
    reader.number("strength", modulation.strength, {0, 1});
    const JsonValue image = reader.required("image", "a picture's path or a raster");
    reader.finish("a modulation");
    modulation.image = read_picture(image, base_dir);
    return modulation;
}

CurveLobe read_curve(ObjectReader& reader) {
    CurveLobe curve;
    if (!reader.has("points")) return curve;
    const JsonValue points = reader.at("points");
    const std::string expected =
        fmt::format("must be a list of 2 to {} points, [[theta, value], ...]", limits::curve_points_max);
    curve.points.clear();
    for (const JsonValue& point : points.elements(expected)) {
        const std::vector<JsonValue> pair = point.elements("must be a point, [theta, value]");
        if (pair.size() != 2) point.fail("must be a point, [theta, value]");
        const double theta = pair[0].number({0, 180});
        if (!curve.points.empty() && theta <= curve.points.back().first)
            pair[0].fail(
                fmt::format("theta must rise from point to point, here above {}", curve.points.back().first));
        curve.points.emplace_back(theta, pair[1].number({0, limits::weight_max}));
    }
    if (curve.points.size() < 2 || curve.points.size() > std::size_t{limits::curve_points_max})
        points.fail(expected);
    bool has_facets = false;
    for (const auto& [theta, value] : curve.points) has_facets = has_facets || value > 0;
    if (!has_facets) points.fail("one point at least needs a value above 0");
    return curve;
}

template <class L>
L read_alphas(ObjectReader& reader) {
    L lobe;
    reader.number("alpha_x", lobe.alpha_x, width_range);
    reader.number("alpha_y", lobe.alpha_y, width_range);
    return lobe;
}

Lobe read_parameters(ObjectReader& reader, Lobe lobe) {
    if (auto* const gaussian = std::get_if<GaussianLobe>(&lobe)) {
        reader.number_or_infinity("sigma_x", gaussian->sigma_x, width_range);
        reader.number_or_infinity("sigma_y", gaussian->sigma_y, width_range);
    } else if (auto* const inverse = std::get_if<InverseGaussianLobe>(&lobe)) {
        reader.number("sigma", inverse->sigma, width_range);
    } else if (std::holds_alternative<GgxLobe>(lobe)) {
        lobe = read_alphas<GgxLobe>(reader);
    } else if (std::holds_alternative<BeckmannLobe>(lobe)) {
        lobe = read_alphas<BeckmannLobe>(reader);
    } else if (auto* const uniform = std::get_if<UniformLobe>(&lobe)) {
        uniform->domain = static_cast<UniformDomain>(reader.choice("domain", domain_names, 0));
    } else if (std::holds_alternative<CurveLobe>(lobe)) {
        lobe = read_curve(reader);
    }
    return lobe;
}

// The lobe that a name stands for, with its default parameters.
Lobe lobe_named(std::size_t index) {
    const Lobe lobes[] = {GaussianLobe{}, InverseGaussianLobe{}, GgxLobe{},    BeckmannLobe{},
                          UniformLobe{},  CurveLobe{},           PaintedLobe{}};
    static_assert(std::size(lobes) == std::variant_size_v<Lobe>);
    return lobes[index];
}

}  // namespace

Layer read_layer(const JsonValue& json, const fs::path& base_dir) {
    ObjectReader reader(json);
    Layer layer;
    const std::size_t kind = reader.choice("lobe", lobe_names, 0);
    reader.text("name", layer.name);
    reader.flag("enabled", layer.enabled);
    reader.number("weight", layer.weight, {0, limits::weight_max});
    layer.lobe = read_parameters(reader, lobe_named(kind));
    reader.number("tilt", layer.tilt, {0, limits::tilt_max});
    reader.number("azimuth", layer.azimuth, {-limits::angle_max, limits::angle_max});
    reader.number("rotation", layer.rotation, {-limits::angle_max, limits::angle_max});
    if (reader.has("modulation")) layer.modulation = read_modulation(reader.at("modulation"), base_dir);
    auto* const painted = std::get_if<PaintedLobe>(&layer.lobe);
    if (painted) {
        const JsonValue image =
            reader.required("image", "a painted layer holds a picture's path or a raster");
        reader.finish("a painted layer");
        painted->image = read_picture(image, base_dir);
    } else {
        reader.finish(fmt::format("a layer with the lobe \"{}\"", lobe_names[kind]));
    }
    return layer;
}

}  // namespace nacre
