// Writes the tree of glsl_tree.h in a language that looks like C.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/formats/glsl_tree.h"

namespace nacre {

class TreeWriter {
  public:
    // Every name that stands outside of functions begins with the prefix and an underscore.
    TreeWriter(const GlslProgram& program, std::string prefix)
        : program_(program), prefix_(std::move(prefix)) {}
    virtual ~TreeWriter() = default;
    TreeWriter(const TreeWriter&) = delete;
    TreeWriter& operator=(const TreeWriter&) = delete;

    // The functions that `roots` call, in order, and themselves. Each begins with `lead`.
    std::string functions(const std::set<std::string>& roots, std::string_view lead);

    std::string expression(const GlslExpression& e) { return expression(e, 0); }
    std::string global(std::string_view name) const { return prefix_ + "_" + std::string(name); }
    virtual std::string type(std::string_view glsl) const = 0;
    virtual std::string name_of(const GlslFunction& function) const = 0;

  protected:
    // How tightly an operator binds; more binds tighter.
    enum Level {
        loosest = 0,
        choice_level = 1,
        or_level,
        and_level,
        equal_level,
        less_level,
        sum_level,
        product_level,
        unary_level,
        member_level
    };

    // A variable's or a field's name, where the language has another use for the word.
    virtual std::string own_name(const std::string& name) const { return name; }
    virtual std::string literal(const GlslExpression& e) const = 0;
    virtual std::string construct(const GlslExpression& e) = 0;
    virtual std::string built_in(const GlslExpression& e) = 0;  // a call of one
    virtual std::string zero(std::string_view type) const = 0;  // to initialise a variable with
    // An operation on vectors; empty where the language has its operators for it.
    virtual std::string vector_operation(std::string_view sign, const GlslExpression& a,
                                         const GlslExpression& b);
    virtual std::string vector_negative(const GlslExpression& a);
    // What comes before the statements of a function that does not use this parameter.
    virtual std::string unused(std::string_view parameter) const = 0;

    std::string expression(const GlslExpression& e, int level);
    std::string list(const GlslExpression& e);  // its operands, with commas
    const GlslProgram& program() const { return program_; }
    const std::string& prefix() const { return prefix_; }

  private:
    std::string operation(const GlslExpression& e, int& own);
    std::string assignment(const GlslExpression& e);
    std::string function(const GlslFunction& function);
    void statement(const GlslStatement& s, int depth, std::string& text);
    void braced(const GlslStatement& s, int depth, std::string& text);
    void loop(const GlslStatement& s, int depth, std::string& text);
    std::string declaration(const GlslStatement& s);

    const GlslProgram& program_;
    std::string prefix_;
    std::set<std::string> used_names_;  // variables of the function that is being written
};

}  // namespace nacre
