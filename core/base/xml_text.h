// Text inside XML.
#pragma once

#include <string>

namespace nacre {

// The text on one line, with what XML takes for markup written as entities.
std::string xml_text(const std::string& utf8);

}  // namespace nacre
