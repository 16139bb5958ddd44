// Text that may not be UTF-8: file names are arbitrary bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nacre {

struct CodePoint {
    std::uint32_t value;
    std::size_t length;  // bytes; 0 where the text is not UTF-8, and then `value` is the byte
};

// The first code point of a text that is not empty.
CodePoint decode_utf8(std::string_view text);

// The text with the replacement character U+FFFD for each byte that is not UTF-8.
std::string as_utf8(std::string_view text);

// The code points of as_utf8(text), and valid code points as UTF-8.
std::u32string code_points(std::string_view text);
std::string encode_utf8(std::u32string_view codes);

}  // namespace nacre
