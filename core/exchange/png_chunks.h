#pragma once

#include <string>
#include <string_view>

namespace nacre {

// A PNG file reduced to the chunks that make its pixels: IHDR, PLTE, tRNS, IDAT and IEND. libpng
// prints what it dislikes about the others, and about a file that is cut or damaged; here that is a
// std::runtime_error with the reason.                                     (PNG, 3rd edition, section 5)
std::string essential_png(std::string_view file);

}  // namespace nacre
