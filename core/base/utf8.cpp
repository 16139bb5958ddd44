#include "core/base/utf8.h"

#include <utf8.h>

#include <iterator>

namespace nacre {

CodePoint decode_utf8(std::string_view text) {
    const char* next = text.data();
    try {
        const std::uint32_t value = utf8::next(next, text.data() + text.size());
        return {value, static_cast<std::size_t>(next - text.data())};
    } catch (const utf8::exception&) {
        return {static_cast<unsigned char>(text.front()), 0};
    }
}

std::string as_utf8(std::string_view text) {
    std::string valid;
    while (true) {
        const auto bad =
            static_cast<std::size_t>(utf8::find_invalid(text.begin(), text.end()) - text.begin());
        valid += text.substr(0, bad);
        if (bad == text.size()) return valid;
        valid += "\uFFFD";
        text.remove_prefix(bad + 1);
    }
}

std::u32string code_points(std::string_view text) {
    const std::string valid = as_utf8(text);
    std::u32string codes;
    utf8::utf8to32(valid.begin(), valid.end(), std::back_inserter(codes));
    return codes;
}

std::string encode_utf8(std::u32string_view codes) {
    std::string text;
    utf8::utf32to8(codes.begin(), codes.end(), std::back_inserter(text));
    return text;
}

}  // namespace nacre
