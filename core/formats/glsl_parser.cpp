#include "core/formats/glsl_parser.h"

#include <fmt/core.h>

#include <utility>

#include "core/formats/glsl_expressions.h"

namespace nacre {
namespace {

using Kind = GlslStatement::Kind;
using StatementPtr = std::unique_ptr<GlslStatement>;

StatementPtr statement_of(Kind kind) {
    auto statement = std::make_unique<GlslStatement>();
    statement->kind = kind;
    return statement;
}

bool ends_function(const GlslStatement& statement) {
    if (statement.kind == Kind::result) return true;
    return statement.kind == Kind::block && !statement.parts.empty() &&
           ends_function(*statement.parts.back());
}

bool declares(const GlslStatement& block) {
    for (const auto& part : block.parts)
        if (part->kind == Kind::declare) return true;
    return false;
}

class Parser {
  public:
    Parser(std::string_view text, const std::vector<GlslVariable>& globals)
        : cursor_(glsl_tokens(text)), scope_(globals), expressions_(cursor_, scope_, program_) {}

    GlslProgram operator()() {
        while (cursor_.now().kind != GlslToken::Kind::end) read_item();
        return std::move(program_);
    }

  private:
    void read_item() {
        const std::string comment = cursor_.now().comment;
        if (cursor_.take("struct")) {
            read_struct(comment);
        } else if (cursor_.take("const")) {
            read_constant(comment);
        } else {
            read_function(comment);
        }
    }

    GlslVariable variable() {
        GlslVariable read;
        read.type = cursor_.take_name();
        read.name = cursor_.take_name();
        return read;
    }

    void read_struct(const std::string& comment) {
        auto made = std::make_unique<GlslStruct>();
        made->name = cursor_.take_name();
        made->comment = comment;
        cursor_.expect("{");
        while (!cursor_.take("}")) {
            made->fields.push_back(variable());
            cursor_.expect(";");
        }
        cursor_.expect(";");
        program_.structs.push_back(std::move(made));
    }

    void read_constant(const std::string& comment) {
        auto made = std::make_unique<GlslConstant>();
        made->variable = variable();
        made->comment = comment;
        cursor_.expect("=");
        made->value = expressions_.choice();
        cursor_.expect(";");
        scope_.add(made->variable);
        program_.constants.push_back(std::move(made));
    }

    void read_function(const std::string& comment) {
        auto made = std::make_unique<GlslFunction>();
        made->type = cursor_.take_name();
        made->name = cursor_.take_name();
        made->comment = comment;
        cursor_.expect("(");
        scope_.open();
        while (!cursor_.take(")")) {
            if (!made->parameters.empty()) cursor_.expect(",");
            made->parameters.push_back(variable());
            scope_.add(made->parameters.back());
        }
        made->body = block();
        scope_.close();
        for (const auto& other : program_.functions)
            if (other->name == made->name) other->overloaded = made->overloaded = true;
        program_.functions.push_back(std::move(made));
    }

    StatementPtr block() {
        StatementPtr made = statement_of(Kind::block);
        cursor_.expect("{");
        scope_.open();
        bool ended = false;
        while (!cursor_.take("}")) {
            StatementPtr part = statement();
            if (!part || ended) continue;  // it is never reached
            ended = ends_function(*part);
            if (part->kind == Kind::block && !declares(*part)) {
                for (auto& inner : part->parts) made->parts.push_back(std::move(inner));
            } else {
                made->parts.push_back(std::move(part));
            }
        }
        scope_.close();
        return made;
    }

    // Nothing where it does nothing.
    StatementPtr statement() {
        if (cursor_.is("{")) return block();
        if (cursor_.take(";")) return {};
        if (cursor_.take("if")) return branch();
        if (cursor_.take("for")) return for_loop();
        if (cursor_.take("while")) return while_loop();
        StatementPtr made;
        if (cursor_.take("return")) {
            made = statement_of(Kind::result);
            made->value = expressions_.choice();
        } else {
            made = simple();
        }
        cursor_.expect(";");
        return made;
    }

    // A declaration or an expression, without its semicolon.
    StatementPtr simple() {
        const bool declaration =
            cursor_.now().kind == GlslToken::Kind::name && cursor_.next().kind == GlslToken::Kind::name;
        if (!declaration) {
            StatementPtr made = statement_of(Kind::evaluate);
            made->value = expressions_.assignment();
            return made;
        }
        StatementPtr made = statement_of(Kind::declare);
        const GlslVariable declared = variable();
        made->type = declared.type;
        made->name = declared.name;
        if (cursor_.take("=")) made->value = expressions_.choice();
        scope_.add(declared);
        return made;
    }

    StatementPtr branch() {
        StatementPtr made = statement_of(Kind::branch);
        cursor_.expect("(");
        made->value = expressions_.choice();
        cursor_.expect(")");
        StatementPtr yes = statement();
        StatementPtr no;
        if (cursor_.take("else")) no = statement();
        if (is_literal(*made->value, "true")) return yes;
        if (is_literal(*made->value, "false")) return no;
        if (!yes) cursor_.fail("if without a statement");
        made->parts.push_back(std::move(yes));
        if (no) made->parts.push_back(std::move(no));
        return made;
    }

    StatementPtr for_loop() {
        StatementPtr made = statement_of(Kind::repeat);
        scope_.open();
        cursor_.expect("(");
        StatementPtr first;
        if (!cursor_.is(";")) first = simple();
        cursor_.expect(";");
        made->value = expressions_.choice();
        cursor_.expect(";");
        made->step = expressions_.assignment();
        cursor_.expect(")");
        made->parts.push_back(statement());
        if (first) made->parts.push_back(std::move(first));
        scope_.close();
        return made;
    }

    StatementPtr while_loop() {
        StatementPtr made = statement_of(Kind::repeat);
        cursor_.expect("(");
        made->value = expressions_.choice();
        cursor_.expect(")");
        made->parts.push_back(statement());
        return made;
    }

    GlslCursor cursor_;
    GlslScope scope_;
    GlslProgram program_;
    GlslExpressionParser expressions_;
};

}  // namespace

GlslProgram parse_glsl(std::string_view text, const std::vector<GlslVariable>& globals) {
    return Parser(text, globals)();
}

}  // namespace nacre
