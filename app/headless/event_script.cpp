#include "app/headless/event_script.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/input_file.h"

namespace nacre {
namespace {

constexpr int frames_max = 100000;
constexpr float pixels_max = 100000;

// The words of one line, taken from left to right; every complaint names the line.
class Line {
  public:
    Line(std::string_view text, const std::string& file, int number)
        : rest_(text), file_(file), number_(number) {
        skip_spaces();
    }

    bool at_end() const { return rest_.empty() || rest_[0] == '#'; }
    int number() const { return number_; }

    [[noreturn]] void fail(const std::string& problem, std::string_view found = {}) const {
        throw UserError(file_, "line " + std::to_string(number_), problem, std::string(found));
    }

    std::string_view word(const char* expected) {
        if (at_end()) fail(std::string("needs ") + expected);
        const auto end = rest_.find_first_of(" \t\r");
        const std::string_view taken = rest_.substr(0, end);
        rest_.remove_prefix(taken.size());
        skip_spaces();
        return taken;
    }

    float real(const char* expected) {
        const std::string_view taken = word(expected);
        return parse_real(taken, expected);
    }

    int whole(const char* expected) {
        const std::string_view taken = word(expected);
        int value = 0;
        const auto [end, error] = std::from_chars(taken.data(), taken.data() + taken.size(), value);
        if (error != std::errc() || end != taken.data() + taken.size() || value < 0 || value > frames_max)
            fail(std::string("needs ") + expected, taken);
        return value;
    }

    std::string quoted() {
        if (rest_.empty() || rest_[0] != '"') fail("needs a text in double quotes", rest_);
        std::string text;
        std::size_t i = 1;
        for (; i < rest_.size() && rest_[i] != '"'; ++i) {
            if (rest_[i] == '\\' && i + 1 < rest_.size()) ++i;
            text += rest_[i];
        }
        if (i >= rest_.size()) fail("has a text without its closing quote", rest_);
        rest_.remove_prefix(i + 1);
        return text;
    }

    Place place() {
        if (rest_.empty() || rest_[0] != '"') {
            const float x = real("a place: X Y or \"WIDGET\"");
            return {.widget = {}, .at = {x, real("a place's Y")}, .polar = false};
        }
        Place place{.widget = quoted()};
        if (place.widget.empty()) fail("has an empty widget name");
        if (!rest_.empty() && rest_[0] == ':') {
            std::string_view fractions = word("a fraction after the colon").substr(1);
            if (fractions.starts_with('@')) {
                place.polar = true;
                place.at = {0, 0};
                fractions.remove_prefix(1);
            }
            const auto comma = fractions.find(',');
            place.at.x = parse_real(fractions.substr(0, comma),
                                    place.polar ? "a polar angle" : "a fraction of the widget's width");
            if (comma != std::string_view::npos)
                place.at.y = parse_real(fractions.substr(comma + 1),
                                        place.polar ? "an azimuth" : "a fraction of the widget's height");
        }
        skip_spaces();
        return place;
    }

    int button() {
        const std::string_view name = word("a button: left, right or middle");
        if (name == "left") return ImGuiMouseButton_Left;
        if (name == "right") return ImGuiMouseButton_Right;
        if (name == "middle") return ImGuiMouseButton_Middle;
        fail("needs a button: left, right or middle", name);
    }

  private:
    void skip_spaces() {
        const auto first = rest_.find_first_not_of(" \t\r");
        rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
    }

    float parse_real(std::string_view taken, const char* expected) const {
        float value = 0;
        const auto [end, error] = std::from_chars(taken.data(), taken.data() + taken.size(), value);
        if (error != std::errc() || end != taken.data() + taken.size() || !(std::abs(value) <= pixels_max))
            fail(std::string("needs ") + expected, taken);
        return value;
    }

    std::string_view rest_;
    const std::string& file_;
    int number_;
};

Event parse_line(Line& line) {
    const std::string_view verb = line.word("an event");
    Event event;
    event.line = line.number();
    if (verb == "move") {
        event.what = events::Move{line.place()};
    } else if (verb == "down" || verb == "up") {
        event.what = events::Button{.button = line.button(), .down = verb == "down"};
    } else if (verb == "click") {
        events::Click click{.at = line.place()};
        if (!line.at_end()) click.button = line.button();
        event.what = click;
    } else if (verb == "drag") {
        events::Drag drag{.from = line.place(), .to = {}};
        drag.to = line.place();
        if (!line.at_end()) drag.frames = line.whole("a number of frames");
        event.what = drag;
    } else if (verb == "wheel") {
        event.what = events::Wheel{line.real("a number of notches")};
    } else if (verb == "key") {
        const std::string_view name = line.word("a key such as Ctrl+S");
        const auto press = ui::parse_key(name);
        if (!press) line.fail("needs a key such as Ctrl+S or Enter", name);
        event.what = events::Key{*press};
    } else if (verb == "text") {
        event.what = events::Text{line.quoted()};
    } else if (verb == "frames") {
        event.what = events::Frames{line.whole("a number of frames")};
    } else if (verb == "wait") {
        event.what = events::Wait{};
    } else if (verb == "drop") {
        event.what = events::Drop{line.quoted()};
    } else if (verb == "focus") {
        event.what = events::Focus{};
    } else {
        line.fail(
            "is no event: move, down, up, click, drag, wheel, key, text, frames, wait, drop and "
            "focus are",
            verb);
    }
    return event;
}

}  // namespace

EventScript parse_events(std::string_view text, const std::string& file_for_errors) {
    EventScript script{.file = file_for_errors, .events = {}};
    text = without_byte_order_mark(text);
    for (int number = 1; !text.empty(); ++number) {
        const auto end = text.find('\n');
        Line line(text.substr(0, end), file_for_errors, number);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.at_end()) continue;
        script.events.push_back(parse_line(line));
        if (!line.at_end()) line.fail("has more than its event needs", line.word("nothing"));
    }
    return script;
}

}  // namespace nacre
