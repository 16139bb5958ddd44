#include "core/design/utf8.h"

namespace nacre {

CodePoint decode_utf8(std::string_view text) {
    constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < 0x80) return {lead, 1};
    const std::size_t length = lead >= 0xF8 ? 0 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 0;
    if (length == 0 || length > text.size()) return {lead, 0};
    std::uint32_t value = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xC0) != 0x80) return {lead, 0};
        value = (value << 6) | (byte & 0x3Fu);
    }
    const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
    if (value < smallest[length] || value > 0x10FFFF || surrogate) return {lead, 0};
    return {value, length};
}

std::string as_utf8(std::string_view text) {
    std::string valid;
    while (!text.empty()) {
        const CodePoint code = decode_utf8(text);
        valid += code.length > 0 ? text.substr(0, code.length) : "\uFFFD";
        text.remove_prefix(code.length > 0 ? code.length : 1);
    }
    return valid;
}

}  // namespace nacre
