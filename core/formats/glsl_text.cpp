#include "core/formats/glsl_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <set>

#include "core/base/error.h"
#include "core/model/parameter_fields.h"
#include "core/shading/shader_variant.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

struct FieldList {
    std::string& text;
    const char* separator = "";

    void add(const std::string& value) {
        text += separator + value;
        separator = ", ";
    }
    void operator()(const char*, int value) { add(std::to_string(value)); }
    void operator()(const char*, double value) { add(glsl_number(value)); }
    void operator()(const char*, dvec2 v) {
        add(fmt::format("vec2({}, {})", glsl_number(v.x), glsl_number(v.y)));
    }
    void operator()(const char*, dvec3 v) {
        add(fmt::format("vec3({}, {}, {})", glsl_number(v.x), glsl_number(v.y), glsl_number(v.z)));
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

// Every name that the text defines outside a function gets the prefix and an underscore, so that it can be
// pasted into any shader.
std::string prefixed(std::string text, const std::string& prefix) {
    static const std::regex definition(
        R"((?:^|\n)(?:#define |struct |const (?:float|int|Surface|Layer) |uniform (?:highp )?sampler2D |CONSTANT (?:int|scalar) |)"
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

}  // namespace

std::string glsl_number(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string surface_constants(const Shading<double>& shading) {
    std::string text =
        fmt::format("const Surface surface = {};\n",
                    constructor("Surface", shading.kinds, shading.surface,
                                constructor("TableShape", shading.kinds, shading.surface.tables)));
    text += fmt::format("const int layer_count = {};\nconst Layer layers[{}] = Layer[{}](\n",
                        shading.layer_count, shading.layer_count, shading.layer_count);
    for (int i = 0; i < shading.layer_count; ++i)
        text += "    " + constructor("Layer", shading.kinds, shading.layers[i]) +
                (i + 1 < shading.layer_count ? ",\n" : ");\n");
    return text;
}

std::string with_word(std::string text, std::string_view word, std::string_view other) {
    const auto in_word = [&](std::size_t at) {
        return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
    };
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at)) {
        if (in_word(at + word.size()) || (at > 0 && in_word(at - 1))) {
            at += word.size();
            continue;
        }
        text.replace(at, word.size(), other);
        at += other.size();
    }
    return text;
}

std::string sampler_fetch(std::string_view name) {
    const std::string_view uniforms = shader_text("uniforms.glsl");
    return with_word(std::string(uniforms.substr(uniforms.find("uniform sampler2D"))), "surface_data", name);
}

std::string without_comments(const std::string& text) {
    static const std::regex comment(R"([ \t]*//[^\n]*)");
    static const std::regex blank(R"(\n[ \t]*(?=\n))");
    return std::regex_replace(std::regex_replace(text, comment, ""), blank, "");
}

std::string glsl_function(const Design& design, const Tables& tables, const std::string& prefix,
                          const std::string& data, const std::string& about_data,
                          const SamplingTable* sampling) {
    const ShaderVariant variant = variant_of(tables.shading);
    std::string text = fmt::format(
        "// {0}: a BRDF made by Nacre (Ashikhmin, Premoze, Shirley 2000). GLSL 3.30 or later.\n"
        "// vec3 {1}_brdf(vec3 k1, vec3 k2): 1/sr. Unit vectors away from the surface, x tangent, y "
        "bitangent,\n"
        "//     z normal; 0 where either is not above the horizon.\n",
        one_line(design.name, 80), prefix);
    if (tables.needs.albedo)
        text +=
            fmt::format("// vec3 {}_albedo(vec3 k): albedo of the whole BRDF toward k, k.z > 0.\n", prefix);
    if (sampling)
        text += fmt::format(
            "// vec4 {0}_sample(vec3 k2, vec3 u): a direction k1, drawn by three numbers in [0, 1), and its "
            "density in 1/sr,\n"
            "//     0 where the sample is lost. float {0}_pdf(vec3 k1, vec3 k2): that density of any k1.\n",
            prefix);
    text += about_data;
    text += prefixed(
        without_comments(variant_definitions(variant) + shared_parameters(variant) +
                         surface_constants(tables.shading) + "\n" + data + shared_mathematics(variant) +
                         (sampling ? sampling_mathematics(tables, *sampling, tables.data.size()) : "")),
        prefix);
    if (tables.needs.albedo)
        text += fmt::format("\nvec3 {0}_albedo(vec3 k) {{\n    return {0}_{1}({0}_direction(k));\n}}\n",
                            prefix, variant.kinds.coated() ? "coated_albedo" : "total_albedo");
    if (sampling) text += sampling_calls(prefix);
    return text;
}

}  // namespace nacre
