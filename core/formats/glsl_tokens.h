// The words of the shared shader text, with its macros resolved: what glsl_parser.h reads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre {

struct GlslToken {
    enum class Kind { name, integer, real, symbol, end };

    Kind kind = Kind::end;
    std::string text;
    std::string comment;  // the comment lines directly above, each with its `//` and an end of line
    int line = 0;         // counted from 1
};

// Knows #define, #undef, `#if` of one word and #endif, and macros whose use fits into a line. The last
// token is the end. Throws std::logic_error where the text is none of this: it is a part of the program.
std::vector<GlslToken> glsl_tokens(std::string_view text);

}  // namespace nacre
