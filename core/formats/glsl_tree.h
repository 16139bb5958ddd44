// The shared shader text as a syntax tree with types, for writing it in other languages.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

struct GlslFunction;

// Types are named as in GLSL: float, int, bool, vec2, vec3 and the text's own structs.
struct GlslExpression {
    enum class Kind {
        literal,    // text: the number, true or false
        name,       // text
        member,     // operands[0].text
        index,      // operands[0][operands[1]]
        call,       // text(operands)
        construct,  // type(operands)
        unary,      // text operands[0]
        binary,     // operands[0] text operands[1]
        choice,     // operands[0] ? operands[1] : operands[2]
        assign      // operands[0] text operands[1]
    };

    Kind kind = Kind::literal;
    std::string text;
    std::string type;
    std::vector<std::unique_ptr<GlslExpression>> operands;
    const GlslFunction* function = nullptr;  // of a call: none where GLSL has it built in
    bool global = false;                     // of a name: it stands outside of functions
};

struct GlslStatement {
    enum class Kind {
        block,     // parts
        declare,   // type name = value, or no value
        evaluate,  // value
        branch,    // if (value) parts[0] else parts[1], or no else
        repeat,    // for (parts[1], or nothing; value; step) parts[0]; without a step: while
        result     // return value
    };

    Kind kind = Kind::block;
    std::string type, name;
    std::unique_ptr<GlslExpression> value, step;
    std::vector<std::unique_ptr<GlslStatement>> parts;
};

struct GlslVariable {
    std::string type, name;
};

struct GlslStruct {
    std::string name, comment;
    std::vector<GlslVariable> fields;
};

struct GlslConstant {
    GlslVariable variable;
    std::string comment;
    std::unique_ptr<GlslExpression> value;
};

struct GlslFunction {
    std::string name, type, comment;
    std::vector<GlslVariable> parameters;
    std::unique_ptr<GlslStatement> body;
    bool overloaded = false;  // another one has its name
};

// Each in the order of the text, where everything stands before its use.
struct GlslProgram {
    std::vector<std::unique_ptr<GlslStruct>> structs;
    std::vector<std::unique_ptr<GlslConstant>> constants;
    std::vector<std::unique_ptr<GlslFunction>> functions;

    const GlslStruct* find_struct(std::string_view name) const {
        for (const auto& one : structs)
            if (one->name == name) return one.get();
        return nullptr;
    }
};

}  // namespace nacre
