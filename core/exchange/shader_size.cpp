#include "core/exchange/shader_size.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

namespace nacre {
namespace {

using Definitions = std::map<std::string, std::string, std::less<>>;

bool starts_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view first_word(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && in_word(text[end])) ++end;
    return text.substr(0, end);
}

// Splits at `operation`, the weaker one first, and asks `holds` of each part.
template <class Holds>
bool any_part(std::string_view condition, std::string_view operation, const Holds& holds) {
    while (true) {
        const std::size_t at = condition.find(operation);
        if (holds(trimmed(condition.substr(0, at)))) return true;
        if (at == condition.npos) return false;
        condition.remove_prefix(at + operation.size());
    }
}

bool is_true(std::string_view condition, const Definitions& definitions) {
    auto atom = [&](std::string_view text) {
        const bool negated = text.starts_with('!');
        if (negated) text = trimmed(text.substr(1));
        const auto found = definitions.find(text);
        const std::string_view value = found == definitions.end() ? text : std::string_view(found->second);
        const bool one =
            !value.empty() && std::isdigit(static_cast<unsigned char>(value[0])) != 0 && value != "0";
        return one != negated;
    };
    auto all = [&](std::string_view text) {
        return !any_part(text, "&&", [&](std::string_view part) { return !atom(part); });
    };
    return any_part(condition, "||", all);
}

std::string without_comments(std::string_view text) {
    static const std::regex comment(R"(//[^\n]*|/\*[\s\S]*?\*/)");
    return std::regex_replace(std::string(text), comment, "");
}

std::string with_definitions(std::string_view line, const Definitions& definitions) {
    std::string result;
    for (std::size_t i = 0; i < line.size();) {
        if (!starts_word(line[i])) {
            result += line[i++];
            continue;
        }
        const std::string_view word = first_word(line.substr(i));
        const auto found = definitions.find(word);
        result += found == definitions.end() ? word : std::string_view(found->second);
        i += word.size();
    }
    return result;
}

// Keeps the lines whose #if blocks all hold.
class Preprocessor {
  public:
    void add(std::string_view line) {
        const std::string_view text = trimmed(line);
        if (!text.starts_with('#')) {
            if (active()) result_ += with_definitions(line, definitions_) + "\n";
            return;
        }
        const std::string_view body = trimmed(text.substr(1));
        const std::string_view directive = first_word(body);
        const std::string_view rest = trimmed(body.substr(directive.size()));
        if (directive == "if") open_.push_back(is_true(rest, definitions_));
        if (directive == "else") open_.back() = !open_.back();
        if (directive == "endif") open_.pop_back();
        if (directive == "define" && active()) {
            const std::string_view name = first_word(rest);
            definitions_[std::string(name)] = trimmed(rest.substr(name.size()));
        }
    }

    std::string result() && { return std::move(result_); }

  private:
    bool active() const { return std::find(open_.begin(), open_.end(), false) == open_.end(); }

    Definitions definitions_;
    std::vector<bool> open_;
    std::string result_;
};

bool fixed_condition(std::string_view after_keyword) {
    static const std::regex fixed(R"(^\s*\(\s*(true|false)\s*\))");
    const std::string head(after_keyword.substr(0, 80));
    return std::regex_search(head, fixed);
}

}  // namespace

std::string preprocessed(std::string_view text) {
    const std::string plain = without_comments(text);
    Preprocessor preprocessor;
    for (std::size_t begin = 0; begin < plain.size();) {
        const std::size_t end = std::min(plain.find('\n', begin), plain.size());
        preprocessor.add(std::string_view(plain).substr(begin, end - begin));
        begin = end + 1;
    }
    return std::move(preprocessor).result();
}

int count_statements(std::string_view text) {
    int count = 0, braces = 0, parentheses = 0;
    bool in_struct = false;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (starts_word(c)) {
            const std::string_view word = first_word(text.substr(i));
            i += word.size();
            if (braces == 0 && word == "struct") in_struct = true;
            const bool condition = word == "if" || word == "for" || word == "while";
            if (condition && !fixed_condition(text.substr(i))) ++count;
            continue;
        }
        if (c == '{') ++braces;
        if (c == '}') --braces;
        if (c == '(') ++parentheses;
        if (c == ')') --parentheses;
        if (c == ';' && braces > 0 && parentheses == 0 && !in_struct) ++count;
        if (c == ';' && braces == 0) in_struct = false;
        ++i;
    }
    return count;
}

int shader_statements(const ShaderVariant& variant, const std::vector<std::string>& also) {
    std::string text = variant_definitions(variant);
    for (const std::string& name : also) text += fmt::format("#define {} 1\n", name);
    return count_statements(preprocessed(text + shared_parameters() + shared_mathematics()));
}

}  // namespace nacre
