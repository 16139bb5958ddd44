// Reads typed values out of a JSON tree. Any mistake is a UserError with the value's
// path, what is allowed there and what was found.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/range.h"

namespace nacre {

// One value of the tree with its path.
class JsonValue {
  public:
    JsonValue(const nlohmann::json& json, std::string path, const std::string& file)
        : json_(&json), path_(std::move(path)), file_(&file) {}

    double number(Range range) const;
    double number_or_infinity(Range range) const;  // "infinity" is infinite
    int whole_number(int low, int high) const;
    bool flag() const;
    std::string text() const;
    std::size_t choice(std::span<const std::string_view> names) const;
    glm::dvec3 colour(Range range) const;
    std::vector<JsonValue> elements(std::string_view expected) const;
    std::vector<float> floats(std::size_t count) const;  // all >= 0

    bool is_text() const;
    bool is_object() const;
    const std::string& path() const { return path_; }
    const std::string& file() const { return *file_; }

    [[noreturn]] void fail(std::string problem) const;  // shows this value as what was found

  private:
    friend class ObjectReader;
    const nlohmann::json* json_;
    std::string path_;
    const std::string* file_;
};

// An object whose keys are asked for one by one. A key that is missing leaves the default; finish()
// refuses keys that were not asked for.
class ObjectReader {
  public:
    explicit ObjectReader(const JsonValue& object);

    bool has(std::string_view key);            // makes the key a known one
    JsonValue at(std::string_view key) const;  // of a key that is there
    JsonValue required(std::string_view key, std::string_view meaning);

    void number(std::string_view key, double& value, Range range);
    void number_or_infinity(std::string_view key, double& value, Range range);
    void flag(std::string_view key, bool& value);
    void text(std::string_view key, std::string& value);
    void colour(std::string_view key, glm::dvec3& value, Range range);
    std::size_t choice(std::string_view key, std::span<const std::string_view> names, std::size_t otherwise);

    // `subject` names what the keys belong to: "a gaussian layer".
    void finish(std::string_view subject) const;

    const std::string& path() const { return object_.path(); }

  private:
    JsonValue object_;
    std::vector<std::string> known_;
};

}  // namespace nacre
