// A field of an RFC 4180 file.
#pragma once

#include <string>

namespace nacre {

// In quotes where its text needs them.
std::string csv_field(const std::string& text);

}  // namespace nacre
