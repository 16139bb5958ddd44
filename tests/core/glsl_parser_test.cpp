// The shared shader text as a tree, and what becomes of it in C and in HLSL.
#include "core/formats/glsl_parser.h"

#include <doctest/doctest.h>

#include <stdexcept>

#include "core/formats/c_writer.h"
#include "core/formats/glsl_tokens.h"
#include "core/formats/hlsl_writer.h"

using namespace nacre;

namespace {

const std::vector<GlslVariable> globals{{"float", "LARGEST"}};

// The last function of the text.
std::string in_c(const std::string& text, const std::string& name = "f") {
    const GlslProgram program = parse_glsl(text, globals);
    CWriter writer(program, "x");
    return writer.functions({name}, "");
}

std::string in_hlsl(const std::string& text, const std::string& name = "f") {
    const GlslProgram program = parse_glsl(text, globals);
    HlslWriter writer(program, "x");
    return writer.functions({name}, "");
}

// Of `float f(float a, float b, int i, bool c, vec3 v)`.
std::string expression_in_c(const std::string& expression, const std::string& type = "float") {
    const std::string text =
        in_c(type + " f(float a, float b, int i, bool c, vec3 v) { return " + expression + "; }");
    const std::size_t at = text.find("return ") + 7;
    return text.substr(at, text.find(';', at) - at);
}

}  // namespace

TEST_SUITE_BEGIN("GLSL translation");

TEST_CASE("parentheses stay where they count and go where they do not") {
    CHECK(expression_in_c("a - (b - a)") == "a - (b - a)");
    CHECK(expression_in_c("(a - b) - a") == "a - b - a");
    CHECK(expression_in_c("a / (b * a)") == "a / (b * a)");
    CHECK(expression_in_c("(a + b) * a") == "(a + b) * a");
    CHECK(expression_in_c("-(a + b)") == "-(a + b)");
    CHECK(expression_in_c("-(-a)") == "-(-a)");
    CHECK(expression_in_c("float(i + 1)") == "(x_real)(i + 1)");
    CHECK(expression_in_c("(c ? a : b) * a") == "(c ? a : b) * a");
    CHECK(expression_in_c("c || a < b && b < a", "bool") == "c || (a < b && b < a)");
    CHECK(expression_in_c("!(c && a < b)", "bool") == "!(c && a < b)");
}

TEST_CASE("vectors become calls, with the operands where they were") {
    CHECK(expression_in_c("v * a - vec3(b)", "vec3") == "x_sub3(x_scale3(v, a), x_splat3(b))");
    CHECK(expression_in_c("a * v", "vec3") == "x_scale3(v, a)");
    CHECK(expression_in_c("v / a", "vec3") == "x_div3(v, x_splat3(a))");
    CHECK(expression_in_c("-v", "vec3") == "x_negative3(v)");
    CHECK(expression_in_c("dot(v, v) + v.y") == "x_dot3(v, v) + v.y");
    CHECK(expression_in_c("max(i, 2)", "int") == "x_max_int(i, 2)");
    CHECK(in_c("vec3 f(vec3 v) { v *= 2.0; return v; }") ==
          "\nx_vec3 x_f(x_vec3 v) {\n    v = x_scale3(v, (x_real)2.0);\n    return v;\n}\n");
}

TEST_CASE("macros are put in, and constant conditions are decided") {
    const std::string head =
        "#define ON true\n#define IS(index) ON\n#define COUNT 3\n#define CASE(index, model) if (IS(index)) p "
        "= "
        "model(a);\n#if ON\nfloat twice(float a) {\n    return a * 2.0;\n}\n#endif\n#if OFF\nno "
        "GLSL\n#endif\n";
    CHECK(in_c(head +
               "float f(float a) {\n    float p = a;\n    CASE(1, twice)\n    if (COUNT == 2) return a;\n"
               "    if (ON && p < a) return p;\n    if (ON) return a;\n    return 3.0;\n}\n") ==
          "\nx_real x_twice(x_real a) {\n    return a * (x_real)2.0;\n}\n"
          "\nx_real x_f(x_real a) {\n    x_real p = a;\n    p = x_twice(a);\n    if (p < a) {\n        "
          "return p;\n"
          "    }\n    return a;\n}\n");
}

TEST_CASE("functions that nothing calls are left out, and overloaded ones are told apart") {
    const std::string text =
        "float g(float a) { return a; }\nvec3 g(vec3 v) { return v; }\nfloat h(float a) { return a; }\n"
        "float f(float a, vec3 v) { return g(a) + g(v).x; }\n";
    CHECK(in_c(text).find("x_h(") == std::string::npos);
    CHECK(in_c(text).find("return x_g_real(a) + x_g_vec3(v).x;") != std::string::npos);
    CHECK(in_hlsl(text).find("return x_g(a) + x_g(v).x;") != std::string::npos);
}

TEST_CASE("structs begin at 0, loops stay loops, and comments stand above their functions") {
    const std::string text =
        "struct S { float a; vec3 v; };\n\n// Counts.\nfloat f(int n) {\n    S s;\n"
        "    for (int i = 0; i < n; ++i) s.a += 1.0;\n    while (s.a > 2.0) s.a /= 2.0;\n    return "
        "s.a;\n}\n";
    CHECK(
        in_c(text) ==
        "\n// Counts.\nx_real x_f(int n) {\n    x_S s = {0, {0, 0, 0}};\n    for (int i = 0; i < n; ++i) {\n"
        "        s.a += (x_real)1.0;\n    }\n    while (s.a > (x_real)2.0) {\n        s.a /= (x_real)2.0;\n  "
        "  }\n"
        "    return s.a;\n}\n");
    CHECK(in_hlsl(text).find("x_S s = (x_S)0;") != std::string::npos);
}

TEST_CASE("HLSL's own words are no names of variables") {
    CHECK(in_hlsl("float f(float linear, vec3 v) { return atan(linear, v.x) + LARGEST; }") ==
          "\nfloat x_f(float linear_, float3 v) {\n    return atan2(linear_, v.x) + x_LARGEST;\n}\n");
    CHECK(in_hlsl("vec3 f(float a) { return vec3(a + 1.0); }").find("(float3)(a + 1.0)") !=
          std::string::npos);
}

TEST_CASE("what is not known is an error that names the line") {
    const auto error = [](const std::string& text) -> std::string {
        try {
            parse_glsl(text, globals);
        } catch (const std::logic_error& wrong) {
            return wrong.what();
        }
        return "";
    };
    CHECK(error("float f(float a) {\n    return b;\n}\n").find("line 2: b is unknown") != std::string::npos);
    CHECK(error("float f(float a) { return noise(a); }\n").find("noise() is unknown") != std::string::npos);
    CHECK(error("float f(vec3 v) { return v.w; }\n").find(".x, .y and .z") != std::string::npos);
    CHECK(error("float g(int i) { return 1.0; }\nfloat f(float a) { return g(a); }\n").find("these types") !=
          std::string::npos);
    CHECK(error("float f(float a) { return a }\n").find("; is missing") != std::string::npos);
    CHECK(error("#if ON\nfloat f(float a) { return a; }\n").find("#endif") != std::string::npos);
    CHECK(error("float f(float a) {\n    return a;\n").find("too early") != std::string::npos);
}

TEST_SUITE_END();
