#include "core/formats/glsl_expressions.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace nacre {
namespace {

using Kind = GlslExpression::Kind;

// From the loosest to the tightest.
constexpr std::array<std::array<std::string_view, 4>, 6> operators{
    {{"||"}, {"&&"}, {"==", "!="}, {"<", ">", "<=", ">="}, {"+", "-"}, {"*", "/"}}};

bool is_type(std::string_view name) {
    constexpr std::array types{"float", "int", "bool", "vec2", "vec3"};
    return std::ranges::find(types, name) != types.end();
}

GlslExpressionPtr literal(std::string text, std::string type) {
    auto made = std::make_unique<GlslExpression>();
    made->text = std::move(text);
    made->type = std::move(type);
    return made;
}

GlslExpressionPtr truth(bool value) { return literal(value ? "true" : "false", "bool"); }

bool is_integer(const GlslExpression& expression) {
    return expression.kind == Kind::literal && expression.type == "int";
}

// The operation, or what it comes to whatever its variables are.
GlslExpressionPtr folded(GlslExpressionPtr operation) {
    GlslExpressionPtr& first = operation->operands.front();
    GlslExpressionPtr& second = operation->operands.back();
    const std::string& sign = operation->text;
    if (operation->kind == Kind::unary && sign == "!" && first->kind == Kind::literal)
        return truth(first->text == "false");
    if (operation->kind != Kind::binary) return operation;
    if (sign == "==" && is_integer(*first) && is_integer(*second)) return truth(first->text == second->text);
    if (sign != "&&" && sign != "||") return operation;
    const char* neutral = sign == "&&" ? "true" : "false";
    const char* final = sign == "&&" ? "false" : "true";
    if (is_literal(*first, neutral) || is_literal(*second, final)) return std::move(second);
    if (is_literal(*second, neutral) || is_literal(*first, final)) return std::move(first);
    return operation;
}

}  // namespace

bool is_vector(std::string_view type) { return type == "vec2" || type == "vec3"; }

bool is_literal(const GlslExpression& expression, std::string_view value) {
    return expression.kind == Kind::literal && expression.text == value;
}

bool GlslCursor::take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
}

void GlslCursor::expect(std::string_view text) {
    if (!take(text)) fail(fmt::format("{} is missing", text));
}

std::string GlslCursor::take_name() {
    if (now().kind != GlslToken::Kind::name) fail("a name is missing");
    return take_any().text;
}

GlslToken GlslCursor::take_any() {
    if (now().kind == GlslToken::Kind::end) fail("the text ends too early");
    return tokens_[at_++];
}

void GlslCursor::fail(std::string_view wrong) const {
    throw std::logic_error(fmt::format("shader text, line {}: {} (at '{}')", now().line, wrong, now().text));
}

GlslScope::GlslScope(const std::vector<GlslVariable>& globals) {
    open();
    for (const GlslVariable& variable : globals) add(variable);
}

std::string GlslScope::find(const std::string& name, bool& global) const {
    for (std::size_t i = blocks_.size(); i-- > 0;) {
        const auto found = blocks_[i].find(name);
        if (found == blocks_[i].end()) continue;
        global = i == 0;
        return found->second;
    }
    return {};
}

GlslExpressionPtr GlslExpressionParser::made(Kind kind, std::string text, GlslExpressionPtr first,
                                             GlslExpressionPtr second) const {
    auto expression = std::make_unique<GlslExpression>();
    expression->kind = kind;
    expression->text = std::move(text);
    expression->operands.push_back(std::move(first));
    if (second) expression->operands.push_back(std::move(second));
    expression->type = type_of_operation(*expression);
    return folded(std::move(expression));
}

std::string GlslExpressionParser::type_of_operation(const GlslExpression& operation) const {
    const std::string& first = operation.operands.front()->type;
    const std::string& second = operation.operands.back()->type;
    if (operation.kind == Kind::unary) return first;
    if (operation.kind == Kind::member) return type_of_member(operation);
    if (operation.kind == Kind::assign) return first;
    if (operation.kind == Kind::index) {
        if (!first.ends_with("[]")) cursor_.fail("only arrays have an index");
        return first.substr(0, first.size() - 2);
    }
    constexpr std::string_view arithmetic = "+-*/";
    if (arithmetic.find(operation.text) == std::string_view::npos) return "bool";
    if (is_vector(first) && is_vector(second) && first != second) cursor_.fail("vectors of two lengths");
    if (is_vector(first)) return first;
    if (is_vector(second)) return second;
    return first == "float" || second == "float" ? "float" : "int";
}

std::string GlslExpressionParser::type_of_member(const GlslExpression& member) const {
    const std::string& of = member.operands.front()->type;
    if (is_vector(of)) {
        if (member.text.size() != 1 || std::string_view("xyz").find(member.text) == std::string_view::npos)
            cursor_.fail("of vectors .x, .y and .z are known");
        return "float";
    }
    if (const GlslStruct* known = program_.find_struct(of))
        for (const GlslVariable& field : known->fields)
            if (field.name == member.text) return field.type;
    cursor_.fail(fmt::format("{} has no field {}", of, member.text));
}

GlslExpressionPtr GlslExpressionParser::assignment() {
    GlslExpressionPtr left = choice();
    for (const char* sign : {"=", "+=", "-=", "*=", "/="})
        if (cursor_.take(sign)) return made(Kind::assign, sign, std::move(left), assignment());
    return left;
}

GlslExpressionPtr GlslExpressionParser::choice() {
    GlslExpressionPtr condition = binary(0);
    if (!cursor_.take("?")) return condition;
    auto expression = std::make_unique<GlslExpression>();
    expression->kind = Kind::choice;
    GlslExpressionPtr yes = choice();
    cursor_.expect(":");
    GlslExpressionPtr no = choice();
    if (is_literal(*condition, "true")) return yes;
    if (is_literal(*condition, "false")) return no;
    expression->type = yes->type;
    for (GlslExpressionPtr* part : {&condition, &yes, &no}) expression->operands.push_back(std::move(*part));
    return expression;
}

GlslExpressionPtr GlslExpressionParser::binary(int level) {
    if (level == static_cast<int>(operators.size())) return unary();
    GlslExpressionPtr left = binary(level + 1);
    const auto& signs = operators[static_cast<std::size_t>(level)];
    while (!cursor_.now().text.empty() && std::ranges::find(signs, cursor_.now().text) != signs.end()) {
        const std::string sign = cursor_.take_any().text;
        left = made(Kind::binary, sign, std::move(left), binary(level + 1));
    }
    return left;
}

GlslExpressionPtr GlslExpressionParser::unary() {
    for (const char* sign : {"-", "!", "++", "--"})
        if (cursor_.take(sign)) return made(Kind::unary, sign, unary());
    return postfix();
}

GlslExpressionPtr GlslExpressionParser::postfix() {
    GlslExpressionPtr expression = primary();
    while (cursor_.is(".") || cursor_.is("[")) {
        if (cursor_.take(".")) {
            expression = made(Kind::member, cursor_.take_name(), std::move(expression));
        } else {
            cursor_.expect("[");
            expression = made(Kind::index, {}, std::move(expression), choice());
            cursor_.expect("]");
        }
    }
    return expression;
}

GlslExpressionPtr GlslExpressionParser::primary() {
    if (cursor_.take("(")) {
        GlslExpressionPtr inner = choice();
        cursor_.expect(")");
        return inner;
    }
    const GlslToken token = cursor_.take_any();
    if (token.kind == GlslToken::Kind::integer) return literal(token.text, "int");
    if (token.kind == GlslToken::Kind::real) return literal(token.text, "float");
    if (token.kind != GlslToken::Kind::name) cursor_.fail("an expression is missing");
    if (token.text == "true" || token.text == "false") return literal(token.text, "bool");
    if (cursor_.is("(")) return call(token.text);
    auto name = std::make_unique<GlslExpression>();
    name->kind = Kind::name;
    name->text = token.text;
    name->type = scope_.find(token.text, name->global);
    if (name->type.empty()) cursor_.fail(fmt::format("{} is unknown", token.text));
    return name;
}

GlslExpressionPtr GlslExpressionParser::call(const std::string& name) {
    auto expression = std::make_unique<GlslExpression>();
    expression->text = name;
    cursor_.expect("(");
    while (!cursor_.take(")")) {
        if (!expression->operands.empty()) cursor_.expect(",");
        expression->operands.push_back(choice());
    }
    if (is_type(name)) {
        expression->kind = Kind::construct;
        expression->type = name;
        if (expression->operands.size() == 1 && expression->operands[0]->type == name)
            return std::move(expression->operands[0]);
        return expression;
    }
    expression->kind = Kind::call;
    expression->function = function_for(*expression);
    if (expression->function) {
        expression->type = expression->function->type;
    } else {
        constexpr std::array known{"abs",    "atan", "clamp", "cos", "dot", "exp",
                                   "length", "log",  "max",   "min", "sin", "sqrt"};
        if (std::ranges::find(known, name) == known.end()) cursor_.fail(fmt::format("{}() is unknown", name));
        const bool number = name == "dot" || name == "length";
        expression->type = number ? "float" : expression->operands.at(0)->type;
    }
    if (name == "none" && expression->operands[0]->kind == Kind::literal)
        return truth(expression->operands[0]->text == "false");
    return expression;
}

const GlslFunction* GlslExpressionParser::function_for(const GlslExpression& call) const {
    bool named = false;
    for (const auto& function : program_.functions) {
        if (function->name != call.text) continue;
        named = true;
        const auto fits = [](const GlslVariable& parameter, const GlslExpressionPtr& argument) {
            return parameter.type == argument->type;
        };
        if (std::ranges::equal(function->parameters, call.operands, fits)) return function.get();
    }
    if (named) cursor_.fail(fmt::format("no {}() takes these types", call.text));
    return nullptr;
}

}  // namespace nacre
