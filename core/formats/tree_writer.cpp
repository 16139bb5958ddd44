#include "core/formats/tree_writer.h"

#include <fmt/core.h>

#include <stdexcept>
#include <vector>

namespace nacre {
namespace {

using Kind = GlslExpression::Kind;

void visit(const GlslExpression& e, const auto& see) {
    see(e);
    for (const auto& operand : e.operands) visit(*operand, see);
}

void visit(const GlslStatement& s, const auto& see) {
    if (s.value) visit(*s.value, see);
    if (s.step) visit(*s.step, see);
    for (const auto& part : s.parts) visit(*part, see);
}

std::set<std::string> names_in(const GlslStatement& s) {
    std::set<std::string> names;
    visit(s, [&](const GlslExpression& e) {
        if (e.kind == Kind::name) names.insert(e.text);
    });
    return names;
}

void add_called(const GlslFunction& function, std::set<const GlslFunction*>& used) {
    if (!used.insert(&function).second) return;
    visit(*function.body, [&](const GlslExpression& e) {
        if (e.function) add_called(*e.function, used);
    });
}

bool is_vector_type(std::string_view type) { return type == "vec2" || type == "vec3"; }

std::string indent(int depth) { return std::string(static_cast<std::size_t>(4 * depth), ' '); }

}  // namespace

std::string TreeWriter::vector_operation(std::string_view, const GlslExpression&, const GlslExpression&) {
    return {};
}

std::string TreeWriter::vector_negative(const GlslExpression&) { return {}; }

std::string TreeWriter::list(const GlslExpression& e) {
    std::string text;
    for (const auto& operand : e.operands) text += (text.empty() ? "" : ", ") + expression(*operand, 0);
    return text;
}

std::string TreeWriter::expression(const GlslExpression& e, int level) {
    int own = member_level;
    const std::string text = operation(e, own);
    return own < level ? "(" + text + ")" : text;
}

// `own` becomes how tightly it binds.
std::string TreeWriter::operation(const GlslExpression& e, int& own) {
    const auto operand = [&](std::size_t i, int level) { return expression(*e.operands.at(i), level); };
    switch (e.kind) {
        case Kind::literal:
            own = unary_level;
            return literal(e);
        case Kind::name:
            return e.global ? global(e.text) : own_name(e.text);
        case Kind::member:
            return operand(0, member_level) + "." + own_name(e.text);
        case Kind::index:
            return operand(0, member_level) + "[" + operand(1, 0) + "]";
        case Kind::call:
            return e.function ? name_of(*e.function) + "(" + list(e) + ")" : built_in(e);
        case Kind::construct:
            own = unary_level;
            return construct(e);
        case Kind::choice:
            own = choice_level;
            return operand(0, or_level) + " ? " + operand(1, choice_level) + " : " + operand(2, choice_level);
        case Kind::assign:
            own = loosest;
            return assignment(e);
        case Kind::unary: {
            std::string call = is_vector_type(e.type) ? vector_negative(*e.operands[0]) : "";
            own = call.empty() ? unary_level : member_level;
            if (!call.empty()) return call;
            const bool twice = e.operands[0]->kind == Kind::unary;
            return e.text + operand(0, twice ? member_level : unary_level);
        }
        case Kind::binary:
            break;
    }
    const bool on_vectors = is_vector_type(e.operands.at(0)->type) || is_vector_type(e.operands.at(1)->type);
    if (on_vectors) {
        const std::string call = vector_operation(e.text, *e.operands[0], *e.operands[1]);
        if (!call.empty()) return call;
    }
    static const std::map<std::string, int> levels{
        {"||", or_level},  {"&&", and_level}, {"==", equal_level},  {"!=", equal_level},
        {"<", less_level}, {">", less_level}, {"<=", less_level},   {">=", less_level},
        {"+", sum_level},  {"-", sum_level},  {"*", product_level}, {"/", product_level}};
    own = levels.at(e.text);
    // Compilers like to see parentheses where && stands beside ||.
    const int inner = own == or_level ? equal_level : own;
    return operand(0, inner) + " " + e.text + " " + operand(1, inner == own ? own + 1 : inner);
}

std::string TreeWriter::assignment(const GlslExpression& e) {
    const std::string target = expression(*e.operands[0], member_level);
    if (e.text != "=" && is_vector_type(e.operands[0]->type)) {
        const std::string call = vector_operation(e.text.substr(0, 1), *e.operands[0], *e.operands[1]);
        if (!call.empty()) return target + " = " + call;
    }
    return target + " " + e.text + " " + expression(*e.operands[1], loosest);
}

std::string TreeWriter::functions(const std::set<std::string>& roots, std::string_view lead) {
    std::set<const GlslFunction*> used;
    for (const auto& function : program_.functions)
        if (roots.count(function->name)) add_called(*function, used);
    std::string text;
    for (const auto& one : program_.functions)
        if (used.count(one.get())) text += "\n" + one->comment + std::string(lead) + function(*one);
    return text;
}

std::string TreeWriter::function(const GlslFunction& function) {
    used_names_ = names_in(*function.body);
    std::string text = type(function.type) + " " + name_of(function) + "(";
    const char* separator = "";
    for (const GlslVariable& parameter : function.parameters) {
        text += fmt::format("{}{} {}", separator, type(parameter.type), own_name(parameter.name));
        separator = ", ";
    }
    text += ") {\n";
    for (const GlslVariable& parameter : function.parameters)
        if (!used_names_.count(parameter.name)) text += unused(own_name(parameter.name));
    for (const auto& part : function.body->parts) statement(*part, 1, text);
    return text + "}\n";
}

std::string TreeWriter::declaration(const GlslStatement& s) {
    return fmt::format("{} {} = {}", type(s.type), own_name(s.name),
                       s.value ? expression(*s.value, 0) : zero(s.type));
}

void TreeWriter::statement(const GlslStatement& s, int depth, std::string& text) {
    switch (s.kind) {
        case GlslStatement::Kind::block:
            text += indent(depth);
            braced(s, depth, text);
            return;
        case GlslStatement::Kind::declare:
            if (used_names_.count(s.name)) text += indent(depth) + declaration(s) + ";\n";
            return;
        case GlslStatement::Kind::evaluate:
            text += indent(depth) + expression(*s.value, 0) + ";\n";
            return;
        case GlslStatement::Kind::result:
            text += indent(depth) + "return " + expression(*s.value, 0) + ";\n";
            return;
        case GlslStatement::Kind::repeat:
            loop(s, depth, text);
            return;
        case GlslStatement::Kind::branch:
            break;
    }
    text += indent(depth) + "if (" + expression(*s.value, 0) + ") ";
    braced(*s.parts[0], depth, text);
    if (s.parts.size() < 2) return;
    text.pop_back();
    text += " else ";
    braced(*s.parts[1], depth, text);
}

void TreeWriter::braced(const GlslStatement& s, int depth, std::string& text) {
    text += "{\n";
    if (s.kind == GlslStatement::Kind::block) {
        for (const auto& part : s.parts) statement(*part, depth + 1, text);
    } else {
        statement(s, depth + 1, text);
    }
    text += indent(depth) + "}\n";
}

void TreeWriter::loop(const GlslStatement& s, int depth, std::string& text) {
    const std::string condition = expression(*s.value, 0);
    text += indent(depth);
    if (!s.step) {
        text += "while (" + condition + ") ";
    } else {
        std::string first;
        if (s.parts.size() > 1) {
            const GlslStatement& start = *s.parts[1];
            first =
                start.kind == GlslStatement::Kind::declare ? declaration(start) : expression(*start.value, 0);
        }
        text += "for (" + first + "; " + condition + "; " + expression(*s.step, 0) + ") ";
    }
    braced(*s.parts[0], depth, text);
}

}  // namespace nacre
