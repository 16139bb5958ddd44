#include "core/formats/glsl_tokens.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <stdexcept>
#include <utility>

namespace nacre {
namespace {

using Tokens = std::vector<GlslToken>;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::size_t number_end(std::string_view line, std::size_t at) {
    while (at < line.size() && (is_digit(line[at]) || line[at] == '.' || line[at] == 'e' ||
                                ((line[at] == '+' || line[at] == '-') && line[at - 1] == 'e')))
        ++at;
    return at;
}

std::size_t symbol_end(std::string_view line, std::size_t at) {
    constexpr std::array pairs{"++", "--", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||"};
    const bool pair = std::ranges::find(pairs, line.substr(at, 2)) != pairs.end();
    return at + (pair ? 2 : 1);
}

Tokens words_of(std::string_view line, int number) {
    Tokens words;
    for (std::size_t at = 0; at < line.size();) {
        if (std::isspace(static_cast<unsigned char>(line[at]))) {
            ++at;
            continue;
        }
        if (line.substr(at, 2) == "//") break;
        GlslToken word;
        std::size_t end = at;
        if (is_letter(line[at])) {
            word.kind = GlslToken::Kind::name;
            while (end < line.size() && (is_letter(line[end]) || is_digit(line[end]))) ++end;
        } else if (is_digit(line[at])) {
            end = number_end(line, at);
            const bool real = line.substr(at, end - at).find_first_of(".e") != std::string_view::npos;
            word.kind = real ? GlslToken::Kind::real : GlslToken::Kind::integer;
        } else {
            word.kind = GlslToken::Kind::symbol;
            end = symbol_end(line, at);
        }
        word.text = line.substr(at, end - at);
        word.line = number;
        words.push_back(std::move(word));
        at = end;
    }
    return words;
}

struct Macro {
    bool takes_arguments = false;
    std::vector<std::string> parameters;
    Tokens body;
};

class Preprocessor {
  public:
    Tokens operator()(std::string_view text) {
        int number = 0;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            read_line(text.substr(begin, end - begin), ++number);
            begin = end + 1;
        }
        if (!open_.empty()) throw std::logic_error("shader text: #if without #endif");
        GlslToken last;
        last.line = number;
        result_.push_back(std::move(last));
        return std::move(result_);
    }

  private:
    void read_line(std::string_view line, int number) {
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string_view::npos) {
            comment_.clear();
        } else if (line[first] == '#') {
            directive(words_of(line.substr(first + 1), number), line.substr(first + 1));
            comment_.clear();
        } else if (line.substr(first, 2) == "//") {
            comment_ += std::string(line.substr(first)) + "\n";
        } else if (shown()) {
            Tokens words = expanded(words_of(line, number), 0);
            if (!words.empty()) words.front().comment = comment_;
            comment_.clear();
            std::ranges::move(words, std::back_inserter(result_));
        }
    }

    bool shown() const { return std::ranges::count(open_, false) == 0; }

    void directive(const Tokens& words, std::string_view line) {
        const std::string& name = words.at(0).text;
        if (name == "endif") {
            if (open_.empty()) throw std::logic_error("shader text: #endif without #if");
            open_.pop_back();
        } else if (name == "if") {
            const Tokens value = expanded({words.begin() + 1, words.end()}, 0);
            if (value.size() != 1) throw std::logic_error(fmt::format("shader text: #{}", line));
            open_.push_back(value[0].text == "true" || value[0].text == "1");
        } else if (!shown()) {
            return;
        } else if (name == "undef") {
            macros_.erase(words.at(1).text);
        } else if (name == "define") {
            define(words, line);
        } else {
            throw std::logic_error(fmt::format("shader text: #{}", line));
        }
    }

    // `(` belongs to the macro where it follows the name at once.
    void define(const Tokens& words, std::string_view line) {
        const std::string& name = words.at(1).text;
        const std::size_t after = line.find(name, line.find("define") + 6) + name.size();
        Macro macro;
        std::size_t at = 2;
        if (after < line.size() && line[after] == '(') {
            macro.takes_arguments = true;
            for (++at; words.at(at).text != ")"; ++at)
                if (words[at].text != ",") macro.parameters.push_back(words[at].text);
            ++at;
        }
        macro.body.assign(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
        macros_[name] = std::move(macro);
    }

    Tokens expanded(const Tokens& words, int depth) const {
        if (depth > 20) throw std::logic_error("shader text: a macro that holds itself");
        Tokens result;
        bool changed = false;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto found =
                words[i].kind == GlslToken::Kind::name ? macros_.find(words[i].text) : macros_.end();
            const bool called = i + 1 < words.size() && words[i + 1].text == "(";
            if (found == macros_.end() || (found->second.takes_arguments && !called)) {
                result.push_back(words[i]);
                continue;
            }
            changed = true;
            const int line = words[i].line;
            std::map<std::string, Tokens> arguments;
            if (found->second.takes_arguments) arguments = arguments_of(found->second, words, i);
            for (const GlslToken& word : found->second.body) {
                const auto argument = arguments.find(word.text);
                const Tokens part = argument == arguments.end() ? Tokens{word} : argument->second;
                std::ranges::copy(part, std::back_inserter(result));
                for (auto fresh = result.end() - std::ssize(part); fresh != result.end(); ++fresh)
                    fresh->line = line;
            }
        }
        return changed ? expanded(result, depth + 1) : result;
    }

    // `at`: the macro's name, then the closing parenthesis.
    static std::map<std::string, Tokens> arguments_of(const Macro& macro, const Tokens& words,
                                                      std::size_t& at) {
        std::map<std::string, Tokens> arguments;
        std::size_t index = 0;
        int depth = 0;
        for (at += 2; words.at(at).text != ")" || depth > 0; ++at) {
            if (words[at].text == "," && depth == 0) {
                ++index;
                continue;
            }
            depth += words[at].text == "(" ? 1 : words[at].text == ")" ? -1 : 0;
            arguments[macro.parameters.at(index)].push_back(words[at]);
        }
        return arguments;
    }

    std::map<std::string, Macro> macros_;
    std::vector<bool> open_;  // of each #if: whether its part counts
    std::string comment_;
    Tokens result_;
};

}  // namespace

std::vector<GlslToken> glsl_tokens(std::string_view text) { return Preprocessor()(text); }

}  // namespace nacre
