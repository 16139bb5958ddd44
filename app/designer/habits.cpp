#include "app/designer/habits.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

namespace nacre {
namespace {

constexpr std::array<std::string_view, 4> blends{"replace", "add", "multiply", "maximum"};
constexpr std::array<std::string_view, 3> scales{"perceptual", "linear", "logarithmic"};
constexpr Range part{0, 1};
constexpr double steadiness_max = 400;  // pixels
constexpr double zoom_lowest = 0.25, zoom_highest = 8;

Brush read_brush(ObjectReader& object) {
    Brush brush;
    object.number("radius", brush.radius, {brush_radius_min, brush_radius_max});
    object.number("hardness", brush.hardness, part);
    object.number("flow", brush.flow, part);
    object.number("opacity", brush.opacity, part);
    object.number("spacing", brush.spacing, {spacing_min, spacing_max});
    object.number("value", brush.value, part);
    brush.blend = static_cast<Blend>(object.choice("combine", blends, 0));
    return brush;
}

std::string brush_text(const Brush& brush) {
    return fmt::format(
        "\"radius\": {}, \"hardness\": {}, \"flow\": {}, \"opacity\": {}, \"spacing\": {}, "
        "\"value\": {}, \"combine\": \"{}\"",
        brush.radius, brush.hardness, brush.flow, brush.opacity, brush.spacing, brush.value,
        blends[static_cast<std::size_t>(brush.blend)]);
}

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

Habits read_habits(const JsonValue& json) {
    Habits habits;
    ObjectReader object(json);
    object.text("tool", habits.tool);
    if (object.has("brush")) {
        ObjectReader brush(object.at("brush"));
        habits.brush = read_brush(brush);
        brush.finish("the brush");
    }
    object.number("steadiness", habits.steadiness, {0, steadiness_max});
    if (object.has("brushes"))
        for (const JsonValue& element : object.at("brushes").elements("a list of brushes")) {
            ObjectReader brush(element);
            const std::string name = brush.required("name", "what the brush is called").text();
            habits.own_brushes.push_back({name, read_brush(brush)});
            brush.finish("a brush");
        }
    habits.scale = static_cast<ScaleKind>(object.choice("scale", scales, 0));
    object.flag("highlight", habits.highlight);
    object.flag("expert", habits.expert);
    object.flag("has_dragged", habits.has_dragged);
    object.flag("has_painted", habits.has_painted);
    object.text("object", habits.object);
    object.number("yaw", habits.yaw, {-360, 360});
    object.number("pitch", habits.pitch, {-180, 180});
    object.number("zoom", habits.zoom, {zoom_lowest, zoom_highest});
    object.finish("the habits");
    return habits;
}

std::string habits_text(const Habits& habits) {
    std::string brushes;
    for (const NamedBrush& named : habits.own_brushes)
        brushes += fmt::format("{}{{\"name\": {}, {}}}", brushes.empty() ? "" : ", ", quoted(named.name),
                               brush_text(named.brush));
    return fmt::format(
        "{{\"tool\": {}, \"brush\": {{{}}}, \"steadiness\": {}, \"brushes\": [{}], \"scale\": \"{}\", "
        "\"highlight\": {}, \"expert\": {}, \"has_dragged\": {}, \"has_painted\": {}, \"object\": {}, "
        "\"yaw\": {}, \"pitch\": {}, \"zoom\": {}}}",
        quoted(habits.tool), brush_text(habits.brush), habits.steadiness, brushes,
        scales[static_cast<std::size_t>(habits.scale)], habits.highlight, habits.expert, habits.has_dragged,
        habits.has_painted, quoted(habits.object), habits.yaw, habits.pitch, habits.zoom);
}

}  // namespace nacre
