#include "core/exchange/shader_variant.h"

#include <fmt/core.h>

#include <cassert>
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
    if (main == "gather.frag") return {"shown.glsl", "environment.glsl", "draw.glsl"};
    if (main != "surface.frag") return {};
    if (variant.surroundings) return {"shown.glsl", "environment.glsl"};
    return {"shown.glsl"};
}

// The lobe that a model of shaders/shared/closed_forms.glsl is written with, if any.
std::optional<int> lobe_of(const std::optional<int>& closed_form) {
    if (closed_form == Shader::MODEL_WARD) return Shader::LOBE_GAUSSIAN;
    if (closed_form == Shader::MODEL_GGX) return Shader::LOBE_GGX;
    if (closed_form == Shader::MODEL_BECKMANN) return Shader::LOBE_BECKMANN;
    return {};
}

std::string shown_definitions(const ShaderVariant& variant) {
    std::string text;
    const auto define = [&](std::string_view name, bool on) {
        text += fmt::format("#define {} {}\n", name, on ? 1 : 0);
    };
    define("CLOSED_FORM", variant.closed_form.has_value());
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
    auto has = [&](int kind) {
        return variant.lobes.count(kind) > 0 || lobe_of(variant.closed_form) == kind;
    };
    define("HAS_GAUSSIAN", has(Shader::LOBE_GAUSSIAN));
    define("HAS_INVERSE_GAUSSIAN", has(Shader::LOBE_INVERSE_GAUSSIAN));
    define("HAS_GGX", has(Shader::LOBE_GGX));
    define("HAS_BECKMANN", has(Shader::LOBE_BECKMANN));
    define("HAS_UNIFORM", has(Shader::LOBE_HEMISPHERE) || has(Shader::LOBE_SPHERE));
    define("HAS_CURVE", has(Shader::LOBE_CURVE));
    define("HAS_PAINTED", has(Shader::LOBE_PAINTED));
    define("HAS_MODULATION", variant.modulation);
    define("HAS_ALBEDO", variant.kinds.albedo);
    define("FRESNEL_SCHLICK", variant.kinds.fresnel == FresnelKind::schlick);
    define("FRESNEL_DIELECTRIC", variant.kinds.fresnel == FresnelKind::dielectric);
    define("FRESNEL_CONDUCTOR", variant.kinds.fresnel == FresnelKind::conductor);
    define("VISIBILITY_CORRELATED", variant.kinds.visibility == VisibilityKind::correlated);
    define("VISIBILITY_SMITH", variant.kinds.visibility == VisibilityKind::smith_correlated);
    define("DIFFUSE_LAMBERTIAN", variant.kinds.diffuse == DiffuseKind::lambertian);
    define("DIFFUSE_COUPLED", variant.kinds.diffuse == DiffuseKind::coupled);
    define("DIFFUSE_METAL", variant.kinds.diffuse == DiffuseKind::metal);
    define("AMBIENT_LIGHT", variant.ambient);
    define("SURROUNDINGS", variant.surroundings);
    text += fmt::format("#define LIGHTS {}\n", variant.lights);
    text += fmt::format("#define CLAMP_VISIBILITY {}\n", variant.kinds.clamp);
    for (const char* kind : {"FRESNEL_IS_SCHLICK", "FRESNEL_IS_DIELECTRIC", "FRESNEL_IS_CONDUCTOR",
                             "VISIBILITY_IS_CORRELATED", "VISIBILITY_IS_SMITH", "READS_ALBEDO"})
        text += fmt::format("#define {} true\n", kind);
    text +=
        fmt::format("#define DIFFUSE_IS_LAMBERTIAN {}\n", variant.kinds.diffuse == DiffuseKind::lambertian);
    text += fmt::format("#define DIFFUSE_IS_COUPLED {}\n", variant.kinds.diffuse == DiffuseKind::coupled);
    text += fmt::format("#define DIFFUSE_IS_METAL {}\n", variant.kinds.diffuse == DiffuseKind::metal);
    return text;
}

std::string shared_parameters() { return text_of("shared/parameters.glsl"); }

std::string shared_mathematics() {
    return text_of("choice.glsl") + "\n" + text_of("shared/fresnel.glsl") + "\n" +
           text_of("shared/lobes.glsl") + "\n" + text_of("shared/tables.glsl") + "\n" +
           text_of("shared/brdf.glsl");
}

std::string fragment_shader(const ShaderVariant& variant, std::string_view main) {
    std::string text = "#version 330 core\n" + variant_definitions(variant) + shown_definitions(variant) +
                       shared_parameters() + "\n" + text_of("uniforms.glsl") + "\n" + shared_mathematics() +
                       "\n";
    if (is_factor(variant.term)) text += text_of("shared/terms.glsl") + "\n";
    if (variant.closed_form) text += text_of("shared/closed_forms.glsl") + "\n";
    for (const std::string_view part : parts_of(variant, main)) text += text_of(part) + "\n";
    return text + text_of(main);
}

}  // namespace nacre
