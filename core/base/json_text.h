// JSON text as a tree, stricter than a plain parser: duplicate keys, numbers that overflow, and
// nesting or sizes that no design has are refused.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace nacre {

// A tree that takes no memory to be given back: nlohmann's own destructor does, and where there is none the
// program ends.
class JsonTree {
  public:
    explicit JsonTree(nlohmann::json&& root);
    JsonTree(JsonTree&& other) noexcept;
    JsonTree& operator=(JsonTree&&) = delete;
    ~JsonTree();

    nlohmann::json& root() { return *root_; }
    const nlohmann::json& root() const { return *root_; }

  private:
    std::unique_ptr<nlohmann::json> root_;
};

// The text is UTF-8, with or without a byte order mark. A syntax error is a UserError whose WHERE is
// `line L, column C`, both counted from 1, columns in characters.
JsonTree parse_json(std::string_view text, const std::string& file);

// The path of a member: `parent.key`, or `parent["odd key"]` for a key that is no plain word.
std::string member_path(const std::string& parent, std::string_view key);
std::string element_path(const std::string& parent, std::size_t index);

}  // namespace nacre
