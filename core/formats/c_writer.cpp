#include "core/formats/c_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace nacre {
namespace {

using Kind = GlslExpression::Kind;

// @: the prefix and an underscore. @MATH(f) is f of <math.h> in the precision of @real.
struct Helper {
    std::string_view name, result, parameters, value;
};

constexpr Helper helpers_in_order[] = {
    {"make2", "vec2", "@real x, @real y", ""},
    {"make3", "vec3", "@real x, @real y, @real z", ""},
    {"splat2", "vec2", "@real s", "@make2(s, s)"},
    {"splat3", "vec3", "@real s", "@make3(s, s, s)"},
    {"sqrt", "real", "@real x", "@MATH(sqrt)(x)"},
    {"exp", "real", "@real x", "@MATH(exp)(x)"},
    {"log", "real", "@real x", "@MATH(log)(x)"},
    {"sin", "real", "@real x", "@MATH(sin)(x)"},
    {"cos", "real", "@real x", "@MATH(cos)(x)"},
    {"abs", "real", "@real x", "@MATH(fabs)(x)"},
    {"atan", "real", "@real y, @real x", "@MATH(atan2)(y, x)"},
    {"min", "real", "@real a, @real b", "b < a ? b : a"},
    {"max", "real", "@real a, @real b", "a < b ? b : a"},
    {"min_int", "int", "int a, int b", "b < a ? b : a"},
    {"max_int", "int", "int a, int b", "a < b ? b : a"},
    {"clamp", "real", "@real x, @real least, @real most", "@min(@max(x, least), most)"},
    {"clamp_int", "int", "int x, int least, int most", "@min_int(@max_int(x, least), most)"},
    {"dot2", "real", "@vec2 a, @vec2 b", "a.x * b.x + a.y * b.y"},
    {"dot3", "real", "@vec3 a, @vec3 b", "a.x * b.x + a.y * b.y + a.z * b.z"},
    {"length2", "real", "@vec2 v", "@sqrt(@dot2(v, v))"},
    {"length3", "real", "@vec3 v", "@sqrt(@dot3(v, v))"},
    {"max3", "vec3", "@vec3 a, @vec3 b", "@make3(@max(a.x, b.x), @max(a.y, b.y), @max(a.z, b.z))"},
    {"min3", "vec3", "@vec3 a, @vec3 b", "@make3(@min(a.x, b.x), @min(a.y, b.y), @min(a.z, b.z))"},
    {"negative2", "vec2", "@vec2 v", "@make2(-v.x, -v.y)"},
    {"negative3", "vec3", "@vec3 v", "@make3(-v.x, -v.y, -v.z)"},
    {"add2", "vec2", "@vec2 a, @vec2 b", "@make2(a.x + b.x, a.y + b.y)"},
    {"sub2", "vec2", "@vec2 a, @vec2 b", "@make2(a.x - b.x, a.y - b.y)"},
    {"mul2", "vec2", "@vec2 a, @vec2 b", "@make2(a.x * b.x, a.y * b.y)"},
    {"div2", "vec2", "@vec2 a, @vec2 b", "@make2(a.x / b.x, a.y / b.y)"},
    {"add3", "vec3", "@vec3 a, @vec3 b", "@make3(a.x + b.x, a.y + b.y, a.z + b.z)"},
    {"sub3", "vec3", "@vec3 a, @vec3 b", "@make3(a.x - b.x, a.y - b.y, a.z - b.z)"},
    {"mul3", "vec3", "@vec3 a, @vec3 b", "@make3(a.x * b.x, a.y * b.y, a.z * b.z)"},
    {"div3", "vec3", "@vec3 a, @vec3 b", "@make3(a.x / b.x, a.y / b.y, a.z / b.z)"},
    {"scale2", "vec2", "@vec2 v, @real s", "@make2(v.x * s, v.y * s)"},
    {"scale3", "vec3", "@vec3 v, @real s", "@make3(v.x * s, v.y * s, v.z * s)"},
};

const Helper* find_helper(std::string_view name) {
    const auto* found = std::ranges::find(helpers_in_order, name, &Helper::name);
    return found == std::end(helpers_in_order) ? nullptr : found;
}

// With the helpers that their values call.
void add_with_needs(std::string_view name, std::set<std::string>& all) {
    const Helper* helper = find_helper(name);
    if (!helper || !all.insert(std::string(name)).second) return;
    const std::string_view value = helper->value;
    for (std::size_t at = value.find('@'); at != value.npos; at = value.find('@', at + 1))
        add_with_needs(value.substr(at + 1, value.find('(', at) - at - 1), all);
}

std::string written(const Helper& helper, const std::string& prefix) {
    const std::string result = helper.result == "int" ? "int" : prefix + "_" + std::string(helper.result);
    std::string body = fmt::format("return {};", helper.value);
    if (helper.name == "make2") body = "@vec2 v;\n    v.x = x;\n    v.y = y;\n    return v;";
    if (helper.name == "make3") body = "@vec3 v;\n    v.x = x;\n    v.y = y;\n    v.z = z;\n    return v;";
    return with_prefix(fmt::format("static inline {} @{}({}) {{\n    {}\n}}\n", result, helper.name,
                                   helper.parameters, body),
                       prefix);
}

}  // namespace

std::string with_prefix(std::string_view text, const std::string& prefix) {
    std::string result;
    for (const char c : text) c == '@' ? result += prefix + "_" : result += c;
    return result;
}

std::string CWriter::type(std::string_view glsl) const {
    if (glsl == "int") return "int";
    if (glsl == "bool") return "int";
    return global(glsl == "float" ? "real" : glsl);
}

std::string CWriter::name_of(const GlslFunction& function) const {
    if (function.name == "brdf") return global("evaluated_brdf");  // a caller's has arrays
    if (!function.overloaded) return global(function.name);
    const std::string& last = function.parameters.back().type;
    return global(function.name + "_" + (last == "float" ? "real" : last));
}

std::string CWriter::literal(const GlslExpression& e) const {
    if (e.type == "bool") return e.text == "true" ? "1" : "0";
    return e.type == "float" ? fmt::format("({}){}", global("real"), e.text) : e.text;
}

std::string CWriter::helper(const std::string& name) {
    if (!find_helper(name)) throw std::logic_error("shader text: C has no " + name);
    used_.insert(name);
    return global(name);
}

std::string CWriter::construct(const GlslExpression& e) {
    if (e.type == "vec2" || e.type == "vec3") {
        const std::string length = e.type.substr(3);
        const bool splat = e.operands.size() == 1;
        return fmt::format("{}({})", helper((splat ? "splat" : "make") + length), list(e));
    }
    return fmt::format("({}){}", type(e.type), expression(*e.operands.at(0), unary_level));
}

std::string CWriter::built_in(const GlslExpression& e) {
    const std::string& of = e.operands.at(0)->type;
    std::string name = e.text;
    if (of == "int") name += "_int";
    if (of == "vec2" || of == "vec3") name += of.substr(3);
    return fmt::format("{}({})", helper(name), list(e));
}

std::string CWriter::zero(std::string_view type) const {
    const GlslStruct* known = program().find_struct(type);
    const std::size_t parts = type == "vec2" ? 2 : type == "vec3" ? 3 : known ? known->fields.size() : 0;
    if (parts == 0) return "0";
    std::string text;
    for (std::size_t i = 0; i < parts; ++i)
        text += (i > 0 ? ", " : "") + (known ? zero(known->fields[i].type) : "0");
    return "{" + text + "}";
}

std::string CWriter::as_vector(const GlslExpression& e, std::string_view type) {
    if (e.type == type) return expression(e, 0);
    return fmt::format("{}({})", helper("splat" + std::string(type.substr(3))), expression(e, 0));
}

std::string CWriter::vector_operation(std::string_view sign, const GlslExpression& a,
                                      const GlslExpression& b) {
    const bool first = a.type.starts_with("vec"), second = b.type.starts_with("vec");
    const std::string type = first ? a.type : b.type;
    if (sign == "*" && first != second)
        return fmt::format("{}({}, {})", helper("scale" + type.substr(3)), expression(first ? a : b, 0),
                           expression(first ? b : a, 0));
    const char* name = sign == "+" ? "add" : sign == "-" ? "sub" : sign == "*" ? "mul" : "div";
    return fmt::format("{}({}, {})", helper(name + type.substr(3)), as_vector(a, type), as_vector(b, type));
}

std::string CWriter::vector_negative(const GlslExpression& a) {
    return fmt::format("{}({})", helper("negative" + a.type.substr(3)), expression(a, 0));
}

std::string CWriter::unused(std::string_view parameter) const {
    return fmt::format("    (void){};\n", parameter);
}

std::string CWriter::structs() const {
    std::string text = with_prefix(
        "\ntypedef struct {\n    @real x, y;\n} @vec2;\n\ntypedef struct {\n    @real x, y, z;\n} @vec3;\n",
        prefix());
    for (const auto& one : program().structs) {
        text += "\n" + one->comment + "typedef struct {\n";
        for (const GlslVariable& field : one->fields)
            text += fmt::format("    {} {};\n", type(field.type), field.name);
        text += "} " + global(one->name) + ";\n";
    }
    return text;
}

std::string CWriter::constants() {
    std::string text;
    for (const auto& one : program().constants)
        text += fmt::format("{}static const {} {} = {};\n", one->comment, type(one->variable.type),
                            global(one->variable.name), expression(*one->value));
    return text;
}

std::string CWriter::helpers() const {
    std::set<std::string> all;
    for (const std::string& name : used_) add_with_needs(name, all);
    std::string text;
    for (const Helper& one : helpers_in_order)
        if (all.count(std::string(one.name))) text += "\n" + written(one, prefix());
    return text;
}

}  // namespace nacre
