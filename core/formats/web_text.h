// The files of core/formats/web/, compiled into the program.
#pragma once

#include <string_view>

namespace nacre {

// The text of a file by its name, for instance "page.html"; empty when there is no such file.
std::string_view web_text(std::string_view name);

}  // namespace nacre
