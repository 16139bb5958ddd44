#include "core/base/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_text.h"

namespace nacre {
namespace {

using nlohmann::json;

std::string describe(const json& value) {
    switch (value.type()) {
        case json::value_t::object:
            return "an object";
        case json::value_t::array:
            return fmt::format("a list of {}", value.size());
        case json::value_t::string:
            return '"' + one_line(value.get_ref<const std::string&>(), 60) + '"';
        default:
            return value.dump();
    }
}

std::string quoted_list(std::span<const std::string_view> names) {
    std::string list;
    for (const std::string_view name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
    return list;
}

bool inside(const json& value, Range range) {
    return value.is_number() && value.get<double>() >= range.low && value.get<double>() <= range.high;
}

// Adding 0 turns a negative zero into a plain one, so that one quantity has one value.
double plain(const json& value) { return value.get<double>() + 0.0; }

}  // namespace

void JsonValue::fail(std::string problem) const {
    throw UserError(*file_, path_.empty() ? "design" : path_, std::move(problem), describe(*json_));
}

double JsonValue::number(Range range) const {
    if (!inside(*json_, range)) fail(fmt::format("must be a number from {} to {}", range.low, range.high));
    return plain(*json_);
}

double JsonValue::number_or_infinity(Range range) const {
    if (*json_ == "infinity") return std::numeric_limits<double>::infinity();
    if (!inside(*json_, range))
        fail(fmt::format("must be a number from {} to {} or \"infinity\"", range.low, range.high));
    return plain(*json_);
}

int JsonValue::whole_number(int low, int high) const {
    if (!json_->is_number_integer() || !inside(*json_, {double(low), double(high)}))
        fail(fmt::format("must be a whole number from {} to {}", low, high));
    return json_->get<int>();
}

bool JsonValue::flag() const {
    if (!json_->is_boolean()) fail("must be true or false");
    return json_->get<bool>();
}

bool JsonValue::is_text() const { return json_->is_string(); }

bool JsonValue::is_object() const { return json_->is_object(); }

std::string JsonValue::text() const {
    if (!json_->is_string()) fail("must be a text");
    return json_->get<std::string>();
}

std::size_t JsonValue::choice(std::span<const std::string_view> names) const {
    if (json_->is_string()) {
        const auto found = std::find(names.begin(), names.end(), json_->get_ref<const std::string&>());
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    }
    fail("must be one of " + quoted_list(names));
}

glm::dvec3 JsonValue::colour(Range range) const {
    const std::string expected = "must be a list of three numbers, [red, green, blue]";
    const std::vector<JsonValue> channels = elements(expected);
    if (channels.size() != 3) fail(expected);
    return {channels[0].number(range), channels[1].number(range), channels[2].number(range)};
}

std::vector<JsonValue> JsonValue::elements(std::string_view expected) const {
    if (!json_->is_array()) fail(std::string(expected));
    std::vector<JsonValue> values;
    values.reserve(json_->size());
    for (const json& element : *json_)
        values.emplace_back(element, element_path(path_, values.size()), *file_);
    return values;
}

std::vector<float> JsonValue::floats(std::size_t count) const {
    // The largest float as it is written; read as a double it lies a little above that float.
    constexpr Range range{0, 3.4028235e38};
    constexpr double most = std::numeric_limits<float>::max();
    if (!json_->is_array() || json_->size() != count)
        fail(fmt::format("must be a list of {} numbers", count));
    std::vector<float> values;
    values.reserve(count);
    for (const json& element : *json_) {
        if (!inside(element, range))
            JsonValue(element, element_path(path_, values.size()), *file_).number(range);
        values.push_back(static_cast<float>(std::min(plain(element), most)));
    }
    return values;
}

ObjectReader::ObjectReader(const JsonValue& object) : object_(object) {
    if (!object.is_object()) object.fail("must be an object, {...}");
}

bool ObjectReader::has(std::string_view key) {
    known_.emplace_back(key);
    return object_.json_->contains(key);
}

JsonValue ObjectReader::at(std::string_view key) const {
    return {(*object_.json_)[std::string(key)], member_path(object_.path_, key), *object_.file_};
}

JsonValue ObjectReader::required(std::string_view key, std::string_view meaning) {
    if (!has(key))
        throw UserError(*object_.file_, member_path(object_.path_, key), fmt::format("missing: {}", meaning));
    return at(key);
}

void ObjectReader::number(std::string_view key, double& value, Range range) {
    if (has(key)) value = at(key).number(range);
}

void ObjectReader::number_or_infinity(std::string_view key, double& value, Range range) {
    if (has(key)) value = at(key).number_or_infinity(range);
}

void ObjectReader::flag(std::string_view key, bool& value) {
    if (has(key)) value = at(key).flag();
}

void ObjectReader::text(std::string_view key, std::string& value) {
    if (has(key)) value = at(key).text();
}

void ObjectReader::colour(std::string_view key, glm::dvec3& value, Range range) {
    if (has(key)) value = at(key).colour(range);
}

std::size_t ObjectReader::choice(std::string_view key, std::span<const std::string_view> names,
                                 std::size_t otherwise) {
    return has(key) ? at(key).choice(names) : otherwise;
}

void ObjectReader::finish(std::string_view subject) const {
    for (const auto& [key, value] : object_.json_->items()) {
        if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
        throw UserError(*object_.file_, member_path(object_.path_, key),
                        fmt::format("not a key of {}, which has {}", subject, fmt::join(known_, ", ")),
                        '"' + one_line(key, 60) + '"');
    }
}

}  // namespace nacre
