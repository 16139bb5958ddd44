#include "core/base/csv_field.h"

#include <string_view>

namespace nacre {

std::string csv_field(const std::string& text) {
    constexpr std::string_view formula = "=+-@\t\r";
    const bool computes = !text.empty() && formula.find(text.front()) != formula.npos;
    if (!computes && text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = computes ? "\"'" : "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace nacre
