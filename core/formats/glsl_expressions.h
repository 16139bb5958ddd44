// The expressions of glsl_parser.h: what they are and which types they have.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/glsl_tokens.h"
#include "core/formats/glsl_tree.h"

namespace nacre {

// A place in the text.
class GlslCursor {
  public:
    explicit GlslCursor(std::vector<GlslToken> tokens) : tokens_(std::move(tokens)) {}

    const GlslToken& now() const { return tokens_[at_]; }
    const GlslToken& next() const { return tokens_[at_ + 1 < tokens_.size() ? at_ + 1 : at_]; }
    bool is(std::string_view text) const { return now().text == text; }
    bool take(std::string_view text);    // steps over it if it is there
    void expect(std::string_view text);  // throws if it is not
    std::string take_name();
    GlslToken take_any();
    [[noreturn]] void fail(std::string_view wrong) const;

  private:
    std::vector<GlslToken> tokens_;
    std::size_t at_ = 0;
};

// The names that are known at a place.
class GlslScope {
  public:
    explicit GlslScope(const std::vector<GlslVariable>& globals);

    void open() { blocks_.emplace_back(); }
    void close() { blocks_.pop_back(); }
    void add(const GlslVariable& variable) { blocks_.back()[variable.name] = variable.type; }
    // The type; empty where the name is unknown.
    std::string find(const std::string& name, bool& global) const;

  private:
    std::vector<std::map<std::string, std::string>> blocks_;  // the first is outside of functions
};

using GlslExpressionPtr = std::unique_ptr<GlslExpression>;

class GlslExpressionParser {
  public:
    GlslExpressionParser(GlslCursor& cursor, const GlslScope& scope, const GlslProgram& program)
        : cursor_(cursor), scope_(scope), program_(program) {}

    GlslExpressionPtr assignment();
    GlslExpressionPtr choice();

  private:
    GlslExpressionPtr binary(int level);
    GlslExpressionPtr unary();
    GlslExpressionPtr postfix();
    GlslExpressionPtr primary();
    GlslExpressionPtr call(const std::string& name);
    GlslExpressionPtr made(GlslExpression::Kind kind, std::string text, GlslExpressionPtr first,
                           GlslExpressionPtr second = {}) const;
    std::string type_of_operation(const GlslExpression& operation) const;
    std::string type_of_member(const GlslExpression& member) const;
    const GlslFunction* function_for(const GlslExpression& call) const;

    GlslCursor& cursor_;
    const GlslScope& scope_;
    const GlslProgram& program_;
};

bool is_vector(std::string_view type);
// `true` or `false`, as a word of the text or found by folding constants.
bool is_literal(const GlslExpression& expression, std::string_view value);

}  // namespace nacre
