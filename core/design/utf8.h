// Text that may be no UTF-8: names of files are any bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nacre {

struct CodePoint {
    std::uint32_t value;
    std::size_t length;  // bytes; 0 where the text is not UTF-8
};

// The first of a text that is not empty.
CodePoint decode_utf8(std::string_view text);

// The text with the replacement character U+FFFD for each byte that is not UTF-8.
std::string as_utf8(std::string_view text);

}  // namespace nacre
