#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/system/atomic_file.h"
#include "core/design/design_file.h"
#include "core/design/source_json.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view layer_indent = "      ";
constexpr std::string_view pixel_indent = "        ";

// The shortest text that reads back as the same number.
std::string number(double value) {
    if (std::isinf(value)) return "\"infinity\"";
    assert(!std::isnan(value));
    return fmt::format("{}", value + 0.0);
}

// The shortest text that reads back as the same float by way of a double, as JSON readers do. Of all
// positive floats only 7.038531e-26 rounds twice and misses; it is written as the double it equals.
void append_float(std::string& text, float value) {
    char digits[32];
    const char* const end = std::to_chars(digits, std::end(digits), value + 0.0f).ptr;
    double back = 0;
    std::from_chars(digits, end, back);
    if (static_cast<float>(back) == value)
        text.append(digits, static_cast<std::size_t>(end - digits));
    else
        text += fmt::format("{}", static_cast<double>(value));
}

// A byte that is not UTF-8 becomes the replacement character.
std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string quoted(std::string_view name) { return quoted(std::string(name)); }

std::string colour(const glm::dvec3& c) {
    return fmt::format("[{}, {}, {}]", number(c.x), number(c.y), number(c.z));
}

std::string raster_text(const Raster& raster) {
    std::string text =
        fmt::format("{{\"width\": {}, \"height\": {}, \"values\": [\n", raster.width, raster.height);
    const auto width = static_cast<std::size_t>(raster.width);
    assert(raster.values.size() == width * static_cast<std::size_t>(raster.height));
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        if (i % width == 0) text += pixel_indent;
        append_float(text, raster.values[i]);
        const bool last = i + 1 == raster.values.size();
        text += (i + 1) % width == 0 ? (last ? "\n" : ",\n") : ", ";
    }
    text += layer_indent;
    return text + "]}";
}

// Where the text will stand.
struct Target {
    fs::path base_dir;  // empty: anywhere
    std::string file;
};

std::string path_text(const fs::path& file, const std::string& where, const Target& target) {
    const fs::path whole = fs::absolute(file).lexically_normal();
    const std::string path =
        (target.base_dir.empty() ? whole : whole.lexically_relative(target.base_dir)).generic_string();
    try {
        return nlohmann::json(path).dump();
    } catch (const nlohmann::json::exception&) {
        throw UserError(target.file, where, "a picture's path must be UTF-8 to stand in a design", path);
    }
}

std::string picture_text(const Picture& picture, const std::string& where, const Target& target) {
    if (!picture.file.empty()) return path_text(picture.file, where, target);
    assert(picture.raster);
    return raster_text(*picture.raster);
}

std::string curve_text(const std::vector<ColourPoint>& points) {
    std::string text;
    for (const auto& [theta, c] : points)
        text += fmt::format("{}[{}, {}, {}, {}]", text.empty() ? "" : ", ", number(theta), number(c.x),
                            number(c.y), number(c.z));
    return '[' + text + ']';
}

std::string curve_text(const std::vector<std::pair<double, double>>& points) {
    std::string text;
    for (const auto& [theta, value] : points)
        text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", number(theta), number(value));
    return '[' + text + ']';
}

// The value of one parameter as JSON text.
template <class T>
std::string value_text(const T& kind, const NumberParameter<T>& parameter) {
    return number(kind.*parameter.member);
}
template <class T>
std::string value_text(const T& kind, const ColourParameter<T>& parameter) {
    return colour(kind.*parameter.member);
}
template <class T>
std::string value_text(const T& kind, const TripleParameter<T>& parameter) {
    return colour(kind.*parameter.member);
}
template <class T, class Enum, std::size_t count>
std::string value_text(const T& kind, const ChoiceParameter<T, Enum, count>& parameter) {
    return quoted(parameter.names.at(static_cast<std::size_t>(kind.*parameter.member)));
}
template <class T>
std::string value_text(const T& kind, const CurveParameter<T>& parameter) {
    return curve_text(kind.*parameter.member);
}

template <class T>
std::string value_text(const T& kind, const ColourCurveParameter<T>& parameter) {
    return curve_text(kind.*parameter.member);
}
template <class T, class Row>
std::string value_text(const T& kind, const ListParameter<T, Row>& parameter);
template <class T, class Set>
std::string value_text(const T& kind, const KindParameter<T, Set>& parameter);

// `, "key": value` of every parameter but pictures, which come last in a layer.
template <class T>
std::string fields_text(const T& kind) {
    std::string text;
    visit_parameters<T>([&]<class Parameter>(const Parameter& parameter) {
        if constexpr (!std::is_same_v<Parameter, PictureParameter<T>>)
            text += fmt::format(", \"{}\": {}", parameter.text.key, value_text(kind, parameter));
    });
    return text;
}

template <class Variant>
std::string parameters_text(const Variant& value) {
    return std::visit([](const auto& kind) { return fields_text(kind); }, value);
}

template <class T, class Row>
std::string value_text(const T& kind, const ListParameter<T, Row>& parameter) {
    std::string text;
    for (const Row& row : kind.*parameter.member)
        text += fmt::format("{}{{{}}}", text.empty() ? "" : ", ", fields_text(row).substr(2));
    return '[' + text + ']';
}

// With the parameters of the kind behind its name.
template <class T, class Set>
std::string value_text(const T& kind, const KindParameter<T, Set>& parameter) {
    const Set& value = kind.*parameter.member;
    return quoted(kind_name(value)) + parameters_text(value);
}

std::string lobe_pictures_text(const Lobe& lobe, const std::string& where, const Target& target) {
    std::string text;
    visit_pictures(lobe, [&](const Picture& picture, std::string_view key) {
        const std::string at = fmt::format("{}.{}", where, key);
        text += fmt::format(", \"{}\": {}", key, picture_text(picture, at, target));
    });
    return text;
}

template <class Variant>
std::string model_text(const Variant& model) {
    return "\"model\": " + quoted(kind_name(model)) + parameters_text(model);
}

bool is_tinted(const Layer& layer) { return layer.tint != glm::dvec3{1}; }

std::string layer_text(const Layer& layer, const std::string& where, const Target& target) {
    std::string text;
    if (!layer.name.empty()) text += fmt::format("\"name\": {}, ", quoted(layer.name));
    if (!layer.enabled) text += "\"enabled\": false, ";
    text += fmt::format("\"lobe\": {}, \"weight\": {}", quoted(kind_name(layer.lobe)), number(layer.weight));
    text += parameters_text(layer.lobe);
    text += fmt::format(", \"tilt\": {}, \"azimuth\": {}, \"rotation\": {}", number(layer.tilt),
                        number(layer.azimuth), number(layer.rotation));
    if (is_tinted(layer)) text += fmt::format(", \"tint\": {}", colour(layer.tint));
    if (layer.source)
        text += fmt::format(
            ", \"source\": {}",
            source_text(*layer.source, path_text(layer.source->image, where + ".source.image", target)));
    text += lobe_pictures_text(layer.lobe, where, target);
    if (layer.modulation)
        text += fmt::format(", \"modulation\": {{\"strength\": {}, \"image\": {}}}",
                            number(layer.modulation->strength),
                            picture_text(layer.modulation->image, where + ".modulation.image", target));
    return text;
}

std::string design_text(const Design& design, const Target& target) {
    std::string text = "{\n";
    text += fmt::format("  \"nacre\": {},\n", version_of(design));
    text += fmt::format("  \"name\": {},\n", quoted(design.name));
    if (!design.note.empty()) text += fmt::format("  \"note\": {},\n", quoted(design.note));
    text += "  \"distribution\": {\n    \"layers\": [\n";
    const std::vector<Layer>& layers = design.distribution.layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string where = fmt::format("distribution.layers[{}]", i);
        text += fmt::format("{}{{{}}}{}\n", layer_indent, layer_text(layers[i], where, target),
                            i + 1 < layers.size() ? "," : "");
    }
    text += "    ],\n";
    text +=
        fmt::format("    \"mean_cosine_scale\": {}\n  }},\n", number(design.distribution.mean_cosine_scale));
    text += fmt::format("  \"shadowing\": {{{}, \"clamp\": {}}},\n", model_text(design.shadowing.model),
                        design.shadowing.clamp);
    text += fmt::format("  \"fresnel\": {{{}}},\n", model_text(design.fresnel));
    text += fmt::format("  \"diffuse\": {{{}}}", model_text(design.diffuse));
    if (has_bounces(design.multibounce))
        text += fmt::format(",\n  \"multibounce\": {{{}}}", model_text(design.multibounce));
    if (design.specular != Specular{})
        text += fmt::format(",\n  \"specular\": {{\"intensity\": {}}}", number(design.specular.intensity));
    if (design.retro != Retro{})
        text += fmt::format(",\n  \"retro\": {{{}}}", fields_text(design.retro).substr(2));
    if (is_coated(design.coat)) text += fmt::format(",\n  \"coat\": {{{}}}", model_text(design.coat));
    return text + "\n}\n";
}

}  // namespace

int version_of(const Design& design) {
    const std::vector<Layer>& layers = design.distribution.layers;
    const bool newer = std::any_of(layers.begin(), layers.end(), [](const Layer& layer) {
        return is_tinted(layer) || layer.source.has_value();
    });
    const bool extended = design.specular != Specular{} || design.retro != Retro{};
    int version = newer || extended ? 2 : 1;
    for (const Layer& layer : layers) version = std::max(version, file_version(layer.lobe));
    return std::max({version, file_version(design.shadowing.model), file_version(design.fresnel),
                     file_version(design.diffuse), file_version(design.multibounce),
                     file_version(design.coat)});
}

std::string design_json(const Design& design, const fs::path& base_dir) {
    return design_text(design, {absolute_folder(base_dir), "design"});
}

std::string portable_design_json(const Design& design) { return design_text(design, {{}, "design"}); }

FileContent save_design(const Design& design, const fs::path& file) {
    const std::string text = design_text(design, {absolute_folder(file.parent_path()), file.string()});
    if (text.size() > limits::file_bytes_max)
        throw UserError(
            file.string(), "write",
            fmt::format("the design needs more than the {} bytes a file may have", limits::file_bytes_max),
            fmt::format("{} bytes", text.size()));
    write_file_atomically(file, text);
    return content_of(text);
}

}  // namespace nacre
