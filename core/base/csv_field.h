// A field of an RFC 4180 file.
#pragma once

#include <string>

namespace nacre {

// In quotes where its text needs them. A text that a spreadsheet would take for a formula (it begins with =,
// +, -, @, a tab or a carriage return) gets an apostrophe first, which spreadsheets show as text.
std::string csv_field(const std::string& text);

}  // namespace nacre
