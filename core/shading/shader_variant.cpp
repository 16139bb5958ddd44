#include "core/shading/shader_variant.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "shaders/shader_text.h"

namespace nacre {
namespace {

using Shader = Shading<double>;

std::string text_of(std::string_view name) {
    const std::string_view text = shader_text(name);
    assert(!text.empty());
    return std::string(text);
}

// The files that a shader builds upon, in order.
std::vector<std::string_view> parts_of(const ShaderVariant& variant, std::string_view main) {
    if (main == "accumulate.frag") return {"shown.glsl", "environment.glsl", "draw.glsl"};
    if (main != "surface.frag") return {};
    if (variant.environment_behind) return {"shown.glsl", "environment.glsl"};
    return {"shown.glsl"};
}

// The lobe that a model of shaders/shared/closed_forms.glsl is written with, if any.
std::optional<int> lobe_of(const std::optional<int>& closed_form) {
    if (closed_form == Shader::MODEL_WARD) return kind_index<Lobe, GaussianLobe>();
    if (closed_form == Shader::MODEL_GGX) return kind_index<Lobe, GgxLobe>();
    if (closed_form == Shader::MODEL_BECKMANN) return kind_index<Lobe, BeckmannLobe>();
    return {};
}

std::set<int> lobes_of(const ShaderVariant& variant) {
    std::set<int> lobes = variant.lobes;
    if (const auto lobe = lobe_of(variant.closed_form)) lobes.insert(*lobe);
    return lobes;
}

// Some kinds of a set as GLSL: the texts of shaders/SET/, and a line CASE(index, NAME_SUFFIX, ...) each to
// stand where the shared text says EACH_...; cmake/kinds.cmake does the same of all kinds for C++.
struct KindTexts {
    std::string functions;
    std::string cases;
};

template <class Variant>
KindTexts kind_texts(std::string_view set, std::string_view macro,
                     std::initializer_list<const char*> suffixes, const std::set<int>& kinds) {
    KindTexts texts;
    for (const int index : kinds) {
        const std::string_view name = KindSet<Variant>::names.at(static_cast<std::size_t>(index));
        texts.functions += text_of(fmt::format("{}/{}.glsl", set, name)) + "\n";
        texts.cases += fmt::format("    {}({}", macro, index);
        for (const char* suffix : suffixes) texts.cases += fmt::format(", {}{}", name, suffix);
        texts.cases += ")\n";
    }
    return texts;
}

// The shared text with these lines where it says `mark`.
std::string with_cases(std::string text, std::string_view mark, const std::string& cases) {
    const std::string line = fmt::format("{}\n", mark);
    for (std::size_t at = text.find(line); at != text.npos; at = text.find(line, at + cases.size()))
        text.replace(at, line.size(), cases);
    return text;
}

// A part that most designs do without, by its macro.
struct OptionalPart {
    const char* macro;
    bool used;
};

std::vector<OptionalPart> optional_parts(const ShaderVariant& variant) {
    return {{"HAS_TINT", variant.kinds.tint != Tint::none},
            {"HAS_MULTIBOUNCE", variant.kinds.bounces()},
            {"HAS_MATT_FACETS", variant.kinds.matt_facets()},
            {"HAS_RETRO", variant.kinds.retro},
            {"HAS_COAT", variant.kinds.coated()},
            {"SHOWS_MULTIBOUNCE", variant.term == Term::multibounce},
            {"SHOWS_RETRO", variant.term == Term::retro},
            {"SHOWS_COAT", variant.term == Term::coat}};
}

// The text with its lines `#if MACRO` to `#endif` and what is between them, or without: a design that does
// not use the part does not even carry the question. Such lines of one part do not nest.
std::string with_resolved(const std::string& text, const OptionalPart& part) {
    const std::string opening = fmt::format("#if {}\n", part.macro);
    std::string result;
    int depth = 0, opened_at = 0;  // of #if, and of the one that is resolved; 0: none
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        const std::string_view line(text.data() + begin, end - begin);
        begin = end;
        depth += line.starts_with("#if") ? 1 : 0;
        const bool opens = line == opening, closes = line.starts_with("#endif") && depth == opened_at;
        if (opens) opened_at = depth;
        if (!opens && !closes && (part.used || opened_at == 0)) result += line;
        depth -= line.starts_with("#endif") ? 1 : 0;
        if (closes) opened_at = 0;
    }
    return result;
}

std::string with_parts_resolved(std::string text, const ShaderVariant& variant) {
    for (const OptionalPart& part : optional_parts(variant)) text = with_resolved(text, part);
    return text;
}

std::string shown_definitions(const ShaderVariant& variant) {
    std::string text;
    const auto define = [&](std::string_view name, bool on) {
        text += fmt::format("#define {} {}\n", name, on ? 1 : 0);
    };
    define("CLOSED_FORM", variant.closed_form.has_value());
    if (variant.kinds.coated()) define("SHOWS_ALL", variant.term == Term::total);
    define("SHOWS_SPECULAR", variant.term == Term::specular);
    define("SHOWS_DIFFUSE", variant.term == Term::diffuse);
    define("SHOWS_FACTOR", is_factor(variant.term));
    define("SHOWS_DENSITY", variant.term == Term::density);
    define("SHOWS_MASKING_1", variant.term == Term::masking1);
    define("SHOWS_MASKING_2", variant.term == Term::masking2);
    define("SHOWS_FRESNEL", variant.term == Term::fresnel);
    return text;
}

}  // namespace

ShaderVariant variant_of(const Shading<double>& shading) {
    ShaderVariant variant;
    variant.kinds = shading.kinds;
    for (int i = 0; i < shading.layer_count; ++i) {
        variant.lobes.insert(shading.layers[i].kind);
        variant.modulation = variant.modulation || shading.layers[i].picture_size > 0;
    }
    return variant;
}

std::string variant_definitions(const ShaderVariant& variant) {
    std::string text =
        "#define scalar float\n#define scalar2 vec2\n#define scalar3 vec3\n"
        "#define real float\n#define real2 vec2\n#define real3 vec3\n#define integer int\n#define condition "
        "bool\n"
        "#define CONSTANT const\n#define PURE\n#define READS\n#define LARGEST 3.402823466e+38\n";
    text += fmt::format("#define MAX_LAYERS {}\n", limits::layers_max);
    auto define = [&](std::string_view name, bool on) {
        text += fmt::format("#define {} {}\n", name, on ? 1 : 0);
    };
    const std::set<int> lobes = lobes_of(variant);
    define("HAS_GAUSSIAN", lobes.count(kind_index<Lobe, GaussianLobe>()) > 0);
    define("HAS_GGX", lobes.count(kind_index<Lobe, GgxLobe>()) > 0);
    define("HAS_BECKMANN", lobes.count(kind_index<Lobe, BeckmannLobe>()) > 0);
    define("HAS_PICTURE", variant.modulation || std::any_of(lobes.begin(), lobes.end(), lobe_reads_picture));
    define("HAS_MODULATION", variant.modulation);
    define("HAS_ALBEDO", variant.kinds.albedo);
    define("HAS_LINEAR_FRESNEL", variant.kinds.fresnel_tables() == FresnelTables::linear);
    define("HAS_EXACT_FRESNEL", variant.kinds.fresnel_tables() == FresnelTables::exact);
    define("AMBIENT_LIGHT", variant.ambient);
    define("ENVIRONMENT_BEHIND", variant.environment_behind);
    text += fmt::format("#define LIGHTS {}\n", variant.lights);
    text += fmt::format("#define CLAMP_VISIBILITY {}\n", variant.kinds.clamp);
    if (variant.kinds.tint != Tint::none) {
        text += "#define TINTED true\n";
        text += fmt::format("#define TINT_VARIES {}\n", variant.kinds.tint == Tint::varied);
    }
    if (variant.kinds.bounces())
        text += fmt::format(
            "#define BOUNCES true\n#define BOUNCE_FACTORS {}\n#define MULTIBOUNCE_IS(index) true\n",
            variant.kinds.bounce_factors());
    if (variant.kinds.retro) text += "#define IS_RETRO true\n";
    if (variant.kinds.coated()) text += "#define IS_COATED true\n#define COAT_IS(index) true\n";
    if (variant.kinds.retro || variant.kinds.bounces() || variant.kinds.coated()) text += "#define OR_ZERO\n";
    // One model of each set is there.
    for (const char* fixed : {"FRESNEL_IS(index)", "FRESNEL_IS_LINEAR", "FRESNEL_IS_EXACT",
                              "MASKING_IS(index)", "DIFFUSE_IS(index)", "READS_ALBEDO"})
        text += fmt::format("#define {} true\n", fixed);
    return text;
}

std::string shared_parameters(const ShaderVariant& variant) {
    return with_parts_resolved(text_of("shared/parameters.glsl"), variant);
}

std::string shared_mathematics(const ShaderVariant& variant) {
    const ShadingKinds& kinds = variant.kinds;
    const KindTexts lobe = kind_texts<Lobe>("lobes", "LOBE_CASE", {"_lobe"}, lobes_of(variant));
    KindTexts fresnel = kind_texts<Fresnel>("fresnel", "FRESNEL_CASE", {"_fresnel"}, {kinds.fresnel});
    if (kinds.fresnel_is_curve())
        fresnel.functions.insert(0, text_of("fetch_curve.glsl") + text_of("shared/fresnel_curve.glsl"));
    const KindTexts masking =
        kind_texts<MaskingModel>("masking", "MASKING_CASE", {"_masking"}, {kinds.masking});
    KindTexts diffuse = kind_texts<Diffuse>("diffuse", "DIFFUSE_CASE",
                                            {"_share", "_diffuse", "_diffuse_albedo"}, {kinds.diffuse});
    if (kinds.matt_facets()) diffuse.functions.insert(0, text_of("shared/matt_facets.glsl") + "\n");
    KindTexts bounces;
    if (kinds.bounces()) {
        bounces = kind_texts<Multibounce>("multibounce", "MULTIBOUNCE_CASE",
                                          {"_amplitude", "_row", "_spread", "_kernel"}, {kinds.multibounce});
        bounces.functions = text_of("shared/bounce_tables.glsl") + "\n" + bounces.functions +
                            text_of("shared/multibounce.glsl");
    }
    const std::string retro = kinds.retro ? text_of("shared/retro.glsl") + "\n" : "";
    const KindTexts coat = kinds.coated()
                               ? kind_texts<Coat>("coat", "COAT_CASE", {"_density", "_area"}, {kinds.coat})
                               : KindTexts{};
    if (kinds.coated() && kinds.fresnel != kind_index<Fresnel, DielectricFresnel>())
        fresnel.functions += text_of("fresnel/dielectric.glsl") + "\n";
    std::string text;
    for (const std::string& part :
         {text_of("choice.glsl"), text_of("shared/fresnel.glsl"), fresnel.functions,
          text_of("shared/pictures.glsl"), lobe.functions, text_of("shared/lobes.glsl"),
          text_of("shared/tables.glsl"), text_of("shared/direction.glsl"), masking.functions,
          text_of("shared/visibility.glsl"), diffuse.functions + bounces.functions,
          retro + (kinds.coated() ? coat.functions + text_of("shared/coat.glsl") + "\n" : ""),
          text_of("shared/brdf.glsl")})
        text += part + "\n";
    text = with_parts_resolved(std::move(text), variant);
    text = with_cases(std::move(text), "EACH_LOBE", lobe.cases);
    text = with_cases(std::move(text), "EACH_FRESNEL", fresnel.cases);
    text = with_cases(std::move(text), "EACH_MASKING", masking.cases);
    text = with_cases(std::move(text), "EACH_MULTIBOUNCE", bounces.cases);
    text = with_cases(std::move(text), "EACH_COAT", coat.cases);
    return with_cases(std::move(text), "EACH_DIFFUSE", diffuse.cases);
}

std::string fragment_shader(const ShaderVariant& variant, std::string_view main) {
    std::string text = "#version 330 core\n" + variant_definitions(variant) + shown_definitions(variant) +
                       shared_parameters(variant) + "\n" + text_of("uniforms.glsl") + "\n" +
                       shared_mathematics(variant) + "\n";
    if (is_factor(variant.term)) text += text_of("shared/terms.glsl") + "\n";
    if (variant.closed_form) text += text_of("shared/closed_forms.glsl") + "\n";
    for (const std::string_view part : parts_of(variant, main))
        text += with_parts_resolved(text_of(part), variant) + "\n";
    return text + with_parts_resolved(text_of(main), variant);
}

}  // namespace nacre
