// JSON text as a tree, with what a plain parser lets through refused: keys that stand twice, numbers
// that overflow, nesting and sizes that no design has.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace nacre {

// The text is UTF-8, with or without a byte order mark. A syntax error is a UserError whose WHERE is
// `line L, column C`, both counted from 1, columns in characters.
nlohmann::json parse_json(std::string_view text, const std::string& file);

// The path of a member: `parent.key`, or `parent["odd key"]` for a key that is no plain word.
std::string member_path(const std::string& parent, std::string_view key);
std::string element_path(const std::string& parent, std::size_t index);

}  // namespace nacre
