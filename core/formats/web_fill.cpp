#include "core/formats/web_fill.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace nacre {

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = i; j < i + 3; ++j)
            three = three << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
        for (unsigned j = 0; j < 4; ++j)
            text += i + j <= bytes.size() ? digits[three >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = text.find("{{", at), close = text.find("}}", open);
        result += text.substr(at, open - at);
        if (open == text.npos) break;
        const std::string_view name = text.substr(open + 2, close - open - 2);
        const auto value = std::ranges::find(values, name, &std::pair<std::string_view, std::string>::first);
        if (value == values.end()) throw std::logic_error("nothing to fill in for " + std::string(name));
        result += value->second;
        at = close + 2;
    }
    return result;
}

}  // namespace nacre
