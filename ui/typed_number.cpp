#include "ui/typed_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace nacre::ui {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

// What printf's format has before and after its one number.
std::pair<std::string, std::string> around(std::string_view format) {
    std::pair<std::string, std::string> parts;
    std::string* part = &parts.first;
    for (std::size_t i = 0; i < format.size(); ++i) {
        if (format[i] != '%') {
            *part += format[i];
        } else if (i + 1 < format.size() && format[i + 1] == '%') {
            *part += format[++i];
        } else {
            i = format.find_first_of("eEfFgG", i);
            part = &parts.second;
        }
    }
    return {std::string(trimmed(parts.first)), std::string(trimmed(parts.second))};
}

std::string_view without(std::string_view text, const std::pair<std::string, std::string>& around) {
    if (!around.first.empty() && text.starts_with(around.first)) text.remove_prefix(around.first.size());
    if (!around.second.empty() && text.ends_with(around.second)) text.remove_suffix(around.second.size());
    return trimmed(text);
}

// In the form that from_chars reads; empty where it is none.
std::string canonical(std::string_view text) {
    std::string number;
    constexpr std::string_view minus = "\u2212";
    if (text.starts_with(minus)) {
        number = "-";
        text.remove_prefix(minus.size());
    } else if (text.starts_with('-') || text.starts_with('+')) {
        if (text[0] == '-') number = "-";
        text.remove_prefix(1);
    }
    const auto digits = [&] {
        std::size_t count = 0;
        while (count < text.size() && std::isdigit(static_cast<unsigned char>(text[count])) != 0) ++count;
        number += text.substr(0, count);
        text.remove_prefix(count);
        return count;
    };
    std::size_t count = digits();
    if (text.starts_with('.') || text.starts_with(',')) {
        number += '.';
        text.remove_prefix(1);
        count += digits();
    }
    if (count == 0) return {};
    if (text.starts_with('e') || text.starts_with('E')) {
        number += 'e';
        text.remove_prefix(1);
        if (text.starts_with('-') || text.starts_with('+')) {
            if (text[0] == '-') number += '-';
            text.remove_prefix(1);
        }
        if (digits() == 0) return {};
    }
    return text.empty() ? number : std::string();
}

bool names_infinity(std::string_view text) {
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return small == "infinity" || small == "infinite" || small == "inf" || text == "\u221e";
}

std::string allowed(const NumberRange& range) {
    return fmt::format("{}{:.6g} to {:.6g}{}", range.whole ? "a whole number, " : "", range.least, range.most,
                       range.infinite ? ", or infinity" : "");
}

}  // namespace

TypedNumber typed_number(std::string_view text, const char* format, const NumberRange& range) {
    const std::string_view bare = without(trimmed(text), around(format));
    if (range.infinite && names_infinity(bare)) return {.value = HUGE_VAL, .problem = {}};
    const std::string found = bare.empty() ? "Nothing" : "\u201c" + std::string(trimmed(text)) + "\u201d";
    const std::string number = canonical(bare);
    if (number.empty()) return {.problem = found + " is not a number. Allowed: " + allowed(range)};
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error == std::errc() && range.whole && value != std::round(value))
        return {.problem = found + " is not a whole number. Allowed: " + allowed(range)};
    if (error != std::errc() || value < range.least || value > range.most)
        return {.problem = found + " is out of range. Allowed: " + allowed(range)};
    return {.value = value, .problem = {}};
}

std::string plain_number(double value) {
    return std::isinf(value) ? "infinity" : fmt::format("{:.6g}", value == 0 ? 0 : value);
}

}  // namespace nacre::ui
