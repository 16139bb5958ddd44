#include "core/formats/hlsl_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace nacre {

std::string HlslWriter::type(std::string_view glsl) const {
    if (glsl == "vec2") return "float2";
    if (glsl == "vec3") return "float3";
    return program().find_struct(glsl) ? global(glsl) : std::string(glsl);
}

std::string HlslWriter::name_of(const GlslFunction& function) const { return global(function.name); }

// HLSL's own words among those that GLSL leaves free.
std::string HlslWriter::own_name(const std::string& name) const {
    constexpr std::array words{"half",   "line",   "linear", "matrix",  "pass",     "pixel",    "point",
                               "sample", "shared", "string", "texture", "triangle", "unsigned", "vector"};
    return std::ranges::find(words, name) == words.end() ? name : name + "_";
}

std::string HlslWriter::literal(const GlslExpression& e) const { return e.text; }

std::string HlslWriter::construct(const GlslExpression& e) {
    const bool splat = e.type.starts_with("vec") && e.operands.size() == 1;
    if (splat) return fmt::format("({}){}", type(e.type), expression(*e.operands[0], unary_level));
    return fmt::format("{}({})", type(e.type), list(e));
}

std::string HlslWriter::built_in(const GlslExpression& e) {
    return fmt::format("{}({})", e.text == "atan" ? "atan2" : e.text, list(e));
}

std::string HlslWriter::zero(std::string_view type_name) const {
    return program().find_struct(type_name) ? fmt::format("({})0", type(type_name)) : "0";
}

std::string HlslWriter::unused(std::string_view) const { return {}; }

std::string HlslWriter::structs() const {
    std::string text;
    for (const auto& one : program().structs) {
        text += "\n" + one->comment + "struct " + global(one->name) + " {\n";
        for (const GlslVariable& field : one->fields)
            text += fmt::format("    {} {};\n", type(field.type), own_name(field.name));
        text += "};\n";
    }
    return text;
}

std::string HlslWriter::constants() {
    std::string text;
    for (const auto& one : program().constants)
        text += fmt::format("{}static const {} {} = {};\n", one->comment, type(one->variable.type),
                            global(one->variable.name), expression(*one->value));
    return text;
}

}  // namespace nacre
