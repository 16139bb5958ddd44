#include "app/designer/habits.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace nacre {
namespace {

constexpr Range part{0, 1};
constexpr double steadiness_max = 400;  // pixels
constexpr double zoom_lowest = 0.25, zoom_highest = 8;

// The place of a name in a list of things that have names.
std::size_t choice_of(ObjectReader& object, std::string_view key, std::span<const Choice> list) {
    std::vector<std::string_view> names;
    for (const Choice& info : list) names.emplace_back(info.name);
    return object.choice(key, names, 0);
}

Brush read_brush(ObjectReader& object) {
    Brush brush;
    object.number("radius", brush.radius, {brush_radius_min, brush_radius_max});
    object.number("hardness", brush.hardness, part);
    object.number("flow", brush.flow, part);
    object.number("opacity", brush.opacity, part);
    object.number("spacing", brush.spacing, {spacing_min, spacing_max});
    object.number("value", brush.value, part);
    brush.blend = static_cast<Blend>(choice_of(object, "combine", blends));
    brush.radius_follows = static_cast<Follows>(choice_of(object, "radius_follows", follows_kinds));
    brush.flow_follows = static_cast<Follows>(choice_of(object, "flow_follows", follows_kinds));
    return brush;
}

std::string brush_text(const Brush& brush) {
    return fmt::format(
        "\"radius\": {}, \"hardness\": {}, \"flow\": {}, \"opacity\": {}, \"spacing\": {}, "
        "\"value\": {}, \"combine\": \"{}\", \"radius_follows\": \"{}\", \"flow_follows\": \"{}\"",
        brush.radius, brush.hardness, brush.flow, brush.opacity, brush.spacing, brush.value,
        blends[static_cast<std::size_t>(brush.blend)].name,
        follows_kinds[static_cast<std::size_t>(brush.radius_follows)].name,
        follows_kinds[static_cast<std::size_t>(brush.flow_follows)].name);
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
    object.number("tolerance", habits.tolerance, part);
    habits.form = static_cast<GradientForm>(choice_of(object, "gradient", gradient_forms));
    habits.scale = static_cast<ScaleKind>(choice_of(object, "scale", density_scales));
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
        "{{\"tool\": {}, \"brush\": {{{}}}, \"steadiness\": {}, \"brushes\": [{}], \"tolerance\": {}, "
        "\"gradient\": \"{}\", \"scale\": \"{}\", "
        "\"highlight\": {}, \"expert\": {}, \"has_dragged\": {}, \"has_painted\": {}, \"object\": {}, "
        "\"yaw\": {}, \"pitch\": {}, \"zoom\": {}}}",
        quoted(habits.tool), brush_text(habits.brush), habits.steadiness, brushes, habits.tolerance,
        gradient_forms[static_cast<std::size_t>(habits.form)].name,
        density_scales[static_cast<std::size_t>(habits.scale)].name, habits.highlight, habits.expert,
        habits.has_dragged, habits.has_painted, quoted(habits.object), habits.yaw, habits.pitch, habits.zoom);
}

}  // namespace nacre
