#include "core/design/kind_read.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/limits.h"
#include "core/image/picture.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

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

std::vector<std::pair<double, double>> kind_detail::read_curve(const JsonValue& json, Range theta_bounds,
                                                               Range value_bounds, int points_max) {
    const std::string expected =
        fmt::format("must be a list of 2 to {} points, [[theta, value], ...]", points_max);
    std::vector<std::pair<double, double>> points;
    for (const JsonValue& point : json.elements(expected)) {
        const std::vector<JsonValue> pair = point.elements("must be a point, [theta, value]");
        if (pair.size() != 2) point.fail("must be a point, [theta, value]");
        const double theta = pair[0].number(theta_bounds);
        if (!points.empty() && theta <= points.back().first)
            pair[0].fail(
                fmt::format("theta must rise from point to point, here above {}", points.back().first));
        points.emplace_back(theta, pair[1].number(value_bounds));
    }
    if (points.size() < 2 || points.size() > static_cast<std::size_t>(points_max)) json.fail(expected);
    const bool has_facets =
        std::any_of(points.begin(), points.end(), [](const auto& point) { return point.second > 0; });
    if (!has_facets) json.fail("one point at least needs a value above 0");
    return points;
}

std::vector<ColourPoint> kind_detail::read_colour_curve(const JsonValue& json, Range theta_bounds,
                                                        Range value_bounds, int points_max) {
    const std::string expected =
        fmt::format("must be a list of 1 to {} points, [[theta, red, green, blue], ...]", points_max);
    std::vector<ColourPoint> points;
    for (const JsonValue& point : json.elements(expected)) {
        const char* const form = "must be a point, [theta, red, green, blue]";
        const std::vector<JsonValue> parts = point.elements(form);
        if (parts.size() != 4) point.fail(form);
        const double theta = parts[0].number(theta_bounds);
        if (!points.empty() && theta <= points.back().theta)
            parts[0].fail(
                fmt::format("theta must rise from point to point, here above {}", points.back().theta));
        points.push_back(
            {theta,
             {parts[1].number(value_bounds), parts[2].number(value_bounds), parts[3].number(value_bounds)}});
    }
    if (points.empty() || points.size() > static_cast<std::size_t>(points_max)) json.fail(expected);
    return points;
}

std::size_t kind_detail::read_kind_name(ObjectReader& reader, std::string_view key,
                                        std::span<const std::string_view> names, std::size_t otherwise,
                                        const char* no_other) {
    if (!reader.has(key)) return otherwise;
    const JsonValue json = reader.at(key);
    const bool known = json.is_text() && std::ranges::find(names, json.text()) != names.end();
    if (!known) json.fail(fmt::format("must be one of \"{}\": {}", fmt::join(names, "\", \""), no_other));
    return json.choice(names);
}

}  // namespace nacre
