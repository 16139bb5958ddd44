// Texts with places to be filled.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nacre {

// The text with a value in the place of each {{name}}; what the values hold is left as it is. A name without
// a value is a std::logic_error.
std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values);

std::string base64(const std::string& bytes);

}  // namespace nacre
