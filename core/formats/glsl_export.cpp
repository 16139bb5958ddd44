#include "core/formats/glsl_export.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/model/parameter_fields.h"
#include "core/shading/shader_variant.h"

namespace nacre {
namespace {

// Shortest digits that read back as the same float, with the point that GLSL wants.
std::string number(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

struct FieldList {
    std::string& text;
    const char* separator = "";

    void add(const std::string& value) {
        text += separator + value;
        separator = ", ";
    }
    void operator()(const char*, int value) { add(std::to_string(value)); }
    void operator()(const char*, double value) { add(number(value)); }
    void operator()(const char*, dvec2 v) { add(fmt::format("vec2({}, {})", number(v.x), number(v.y))); }
    void operator()(const char*, dvec3 v) {
        add(fmt::format("vec3({}, {}, {})", number(v.x), number(v.y), number(v.z)));
    }
};

// Without the fields that a design without some part does not have in its GLSL.
bool has_field(const ShadingKinds& kinds, std::string_view field) {
    if (field == "tint") return kinds.tint != Tint::none;
    if (field == "retro") return kinds.retro;
    if (field.starts_with("facet_")) return kinds.matt_facets();
    if (field.starts_with("coat_")) return kinds.coated();
    constexpr std::string_view offsets[] = {"row_offset",       "factor_offset",    "spread_offset",
                                            "whole_offset",     "amplitude_offset", "sum_offset",
                                            "difference_offset"};
    const bool of_bounces = field.starts_with("bounce_") || field.starts_with("momentum_") ||
                            std::ranges::find(offsets, field) != std::end(offsets);
    return kinds.bounces() || !of_bounces;
}

template <class Struct>
std::string constructor(const char* name, const ShadingKinds& kinds, const Struct& value,
                        const std::string& first = {}) {
    std::string text = fmt::format("{}(", name);
    FieldList fields{text};
    if (!first.empty()) fields.add(first);
    visit_fields(value, [&](const char* field, const auto& v) {
        if (has_field(kinds, field)) fields(field, v);
    });
    return text + ")";
}

// Stands in the text, where GLSL has no such sign, for the tables' numbers: they hold no names.
constexpr char numbers_here = '@';

std::string numbers(const std::vector<float>& data) {
    std::string text;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (i > 0) text += ',';
        text += i % 12 == 0 ? "\n    " : " ";
        text += number(static_cast<double>(data[i]));
    }
    return text;
}

std::string constants(const Tables& tables) {
    const Shading<double>& shading = tables.shading;
    std::string text =
        fmt::format("const Surface surface = {};\n",
                    constructor("Surface", shading.kinds, shading.surface,
                                constructor("TableShape", shading.kinds, shading.surface.tables)));
    text += fmt::format("const int layer_count = {};\nconst Layer layers[{}] = Layer[{}](\n",
                        shading.layer_count, shading.layer_count, shading.layer_count);
    for (int i = 0; i < shading.layer_count; ++i)
        text += "    " + constructor("Layer", shading.kinds, shading.layers[i]) +
                (i + 1 < shading.layer_count ? ",\n" : ");\n");
    text += fmt::format("\nconst float data[{}] = float[{}]({}", tables.data.size(), tables.data.size(),
                        numbers_here);
    return text + ");\n\nfloat fetch(int index) {\n    return data[index];\n}\n";
}

// Every name that the text defines outside a function gets the prefix and an underscore, so that it can be
// pasted into any shader.
std::string prefixed(std::string text, const std::string& prefix) {
    static const std::regex definition(
        R"((?:^|\n)(?:#define |struct |const (?:float|int|Surface|Layer) |CONSTANT (?:int|scalar) |)"
        R"((?:PURE )?(?:float|real3|real2|real|int|integer|condition|TableRows|TableSpot|AlbedoSpot|MomentumSpot|FacetSpot|Direction|HalfVector) (?=\w+\())(\w+))");
    std::set<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match)
        names.insert((*match)[1].str());
    std::string result;
    static const std::regex word(R"([A-Za-z_]\w*)");
    std::size_t done = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match) {
        const std::size_t at = static_cast<std::size_t>(match->position());
        result.append(text, done, at - done);
        const bool member = at > 0 && text[at - 1] == '.';
        result += !member && names.count(match->str()) ? prefix + "_" + match->str() : match->str();
        done = at + static_cast<std::size_t>(match->length());
    }
    return result + text.substr(done);
}

std::string without_comments(const std::string& text) {
    static const std::regex comment(R"([ \t]*//[^\n]*)");
    static const std::regex blank(R"(\n[ \t]*(?=\n))");
    return std::regex_replace(std::regex_replace(text, comment, ""), blank, "");
}

}  // namespace

std::string glsl_export(const Design& design, const Tables& tables, const std::string& prefix) {
    ShaderVariant variant = variant_of(tables.shading);
    std::string body = variant_definitions(variant) + shared_parameters(variant) + constants(tables) +
                       shared_mathematics(variant);
    std::string head = fmt::format(
        "// {0}: a BRDF made by Nacre (Ashikhmin, Premoze, Shirley 2000). GLSL 3.30 or later.\n"
        "// vec3 {1}_brdf(vec3 k1, vec3 k2): 1/sr. Unit vectors away from the surface, x tangent, y "
        "bitangent,\n"
        "//     z normal; 0 where either is not above the horizon.\n",
        one_line(design.name, 80), prefix);
    if (tables.needs.albedo)
        head +=
            fmt::format("// vec3 {}_albedo(vec3 k): albedo of the whole BRDF toward k, k.z > 0.\n", prefix);
    std::string text = prefixed(without_comments(body), prefix);
    text.replace(text.find(numbers_here), 1, numbers(tables.data));
    text.insert(0, head);
    if (tables.needs.albedo)
        text += fmt::format("\nvec3 {0}_albedo(vec3 k) {{\n    return {0}_{1}({0}_direction(k));\n}}\n",
                            prefix, variant.kinds.coated() ? "coated_albedo" : "total_albedo");
    return text;
}

}  // namespace nacre
