#include "core/base/json_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/limits.h"
#include "core/base/utf8.h"

namespace nacre {
namespace {

using nlohmann::json;

constexpr std::size_t depth_max = 32;
constexpr std::size_t array_max = std::size_t{limits::raster_max} * limits::raster_max;
// Every layer may hold a raster and a modulation; keys, texts and containers are few beside them.
constexpr std::size_t numbers_max = 2 * (std::size_t{limits::layers_max} + 1) * array_max;
constexpr std::size_t others_max = 50'000;

std::string line_and_column(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, std::min(position, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t newline = before.rfind('\n');
    const std::string_view row = newline == before.npos ? before : before.substr(newline + 1);
    return fmt::format("line {}, column {}", line, code_points(row).size() + 1);
}

// nlohmann's message is `[json.exception...] parse error at line L, column C: REASON; last read: 'TEXT';
// expected X`.
std::string syntax_reason(std::string message) {
    if (const std::size_t colon = message.find(": "); colon != message.npos) message.erase(0, colon + 2);
    const std::size_t read = message.find("; last read: '");
    if (read == message.npos) return message;
    const std::size_t expected = message.rfind("'; expected ");
    const bool keeps_tail = expected != message.npos && expected > read;
    return message.substr(0, read) + (keeps_tail ? message.substr(expected + 1) : "");
}

// From the leaves on: a container without elements is given back without memory.
void empty(json& node) {
    if (auto* const array = node.get_ptr<json::array_t*>()) {
        for (json& element : *array)
            if (element.is_structured()) empty(element);
        array->clear();
    } else if (auto* const object = node.get_ptr<json::object_t*>()) {
        for (auto& [key, member] : *object) empty(member);
        object->clear();
    }
}

class TreeBuilder final : public nlohmann::json_sax<json> {
  public:
    TreeBuilder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    JsonTree tree{json()};

    bool null() override { return place_other(nullptr); }
    bool boolean(bool value) override { return place_other(value); }
    bool number_integer(number_integer_t value) override { return place_number(value); }
    bool number_unsigned(number_unsigned_t value) override { return place_number(value); }
    bool number_float(number_float_t value, const string_t&) override { return place_number(value); }
    bool string(string_t& value) override { return place_other(std::move(value)); }
    bool binary(binary_t&) override { return false; }

    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override {
        Frame& frame = open_.back();
        frame.key = std::move(value);
        if (frame.node->contains(frame.key)) throw UserError(file_, here(), "this key stands twice");
        count(others_, others_max);
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const json::exception& error) override {
        constexpr int number_overflow = 406;
        if (error.id == number_overflow)
            throw UserError(file_, here(), "the number is too large to be held", token);
        const std::size_t last = position == 0 ? 0 : position - 1;
        const bool at_end = last >= text_.size();
        throw UserError(file_, line_and_column(text_, last), syntax_reason(error.what()),
                        at_end ? (text_.empty() ? "the file is empty" : "end of the file")
                               : "read: " + one_line(token, 40));
    }

  private:
    struct Frame {
        json* node;
        std::string key;  // of an object's member that is being read
    };

    // The path of the value or key being read. Where a list is not the innermost container, its last
    // element is the one that is open.
    std::string here() const {
        std::string path;
        for (const Frame& frame : open_) {
            const bool innermost = &frame == &open_.back();
            path = frame.node->is_array() ? element_path(path, frame.node->size() - (innermost ? 0 : 1))
                                          : member_path(path, frame.key);
        }
        return path.empty() ? "design" : path;
    }

    void count(std::size_t& counter, std::size_t most) {
        if (++counter > most) throw UserError(file_, here(), "the file holds more than any design has");
    }

    // A pointer stays valid while its node is open: only the innermost container grows.
    json* place(json value) {
        if (open_.empty()) return &(tree.root() = std::move(value));
        Frame& frame = open_.back();
        if (frame.node->is_object()) return &((*frame.node)[frame.key] = std::move(value));
        if (frame.node->size() == array_max)
            throw UserError(file_, here(), fmt::format("a list holds at most {} values", array_max));
        frame.node->push_back(std::move(value));
        return &frame.node->back();
    }

    bool place_number(json value) {
        count(numbers_, numbers_max);
        place(std::move(value));
        return true;
    }

    bool place_other(json value) {
        count(others_, others_max);
        place(std::move(value));
        return true;
    }

    bool open(json container) {
        if (open_.size() == depth_max)
            throw UserError(file_, here(), fmt::format("nested deeper than {} levels", depth_max));
        count(others_, others_max);
        json* const node = place(std::move(container));
        open_.push_back({node, {}});
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    std::string_view text_;
    const std::string& file_;
    std::vector<Frame> open_;
    std::size_t numbers_ = 0;
    std::size_t others_ = 0;
};

}  // namespace

JsonTree::JsonTree(json&& root) : root_(std::make_unique<json>(std::move(root))) {}

JsonTree::JsonTree(JsonTree&& other) noexcept = default;

JsonTree::~JsonTree() {
    if (root_) empty(*root_);
}

JsonTree parse_json(std::string_view text, const std::string& file) {
    text = without_byte_order_mark(text);
    // nlohmann's parser takes a zero byte for the end and ignores what follows.
    if (const std::size_t zero = text.find('\0'); zero != text.npos)
        throw UserError(file, line_and_column(text, zero), "not JSON text", "a zero byte");
    TreeBuilder builder(text, file);
    json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder.tree);
}

std::string member_path(const std::string& parent, std::string_view key) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    const std::string separator = parent.empty() ? "" : ".";
    if (!key.empty() && std::all_of(key.begin(), key.end(), plain)) {
        return parent + separator + one_line(key, 40);
    }
    return fmt::format("{}[\"{}\"]", parent, one_line(key, 40));
}

std::string element_path(const std::string& parent, std::size_t index) {
    return fmt::format("{}[{}]", parent, index);
}

}  // namespace nacre
