#include "app/headless/event_script.h"

#include <doctest/doctest.h>

#include "core/base/error.h"

using namespace nacre;

namespace {

std::string complaint(const char* text) {
    try {
        parse_events(text, "tour.txt");
    } catch (const UserError& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

TEST_CASE("event script: every event") {
    const EventScript script = parse_events(
        "# a tour\n"
        "move 10 20.5\n"
        "\n"
        "  down right   # held\n"
        "up right\r\n"
        "click \"Width x\":0.25\n"
        "click \"Width x\":0.25,0.75 middle\n"
        "drag 1 2 \"Preview\" 25\n"
        "wheel -2\n"
        "key Ctrl+Shift+S\n"
        "text \"a \\\"quoted\\\" \\\\ word # here\"\n"
        "frames 12\n"
        "wait\n"
        "move \"Canvas\":@30,-45\n"
        "drop \"a picture.png\"",
        "tour.txt");
    REQUIRE(script.events.size() == 13);
    CHECK(std::get<events::Drop>(script.events[12].what).file == "a picture.png");
    CHECK(std::get<events::Move>(script.events[11].what).to == Place{"Canvas", {30, -45}, true});
    CHECK(std::get<events::Move>(script.events[0].what).to.at == glm::vec2(10, 20.5f));
    CHECK(script.events[0].line == 2);
    CHECK(std::get<events::Button>(script.events[1].what).button == 1);
    CHECK(!std::get<events::Button>(script.events[2].what).down);
    CHECK(std::get<events::Click>(script.events[3].what).at == Place{"Width x", {0.25f, 0.5f}, false});
    CHECK(std::get<events::Click>(script.events[4].what).button == 2);
    CHECK(std::get<events::Click>(script.events[4].what).at.at.y == 0.75f);
    CHECK(std::get<events::Drag>(script.events[5].what).frames == 25);
    CHECK(std::get<events::Drag>(script.events[5].what).to == Place{"Preview", {0.5f, 0.5f}, false});
    CHECK(std::get<events::Wheel>(script.events[6].what).notches == -2);
    CHECK(std::get<events::Key>(script.events[7].what).press == ui::KeyPress{'S', true, true, false});
    CHECK(std::get<events::Text>(script.events[8].what).utf8 == "a \"quoted\" \\ word # here");
    CHECK(std::get<events::Frames>(script.events[9].what).count == 12);
    CHECK(script.events[10].line == 13);
}

TEST_CASE("event script: a byte order mark before the first line is skipped, and nowhere else") {
    CHECK(parse_events("\xEF\xBB\xBFmove 10 20\nwait\n", "tour.txt").events.size() == 2);
    CHECK(parse_events("\xEF\xBB\xBF", "tour.txt").events.empty());
    CHECK(complaint("wait\n\xEF\xBB\xBFwait\n").find("line 2") != std::string::npos);
}

TEST_CASE("event script: what is wrong is named with its line") {
    CHECK(complaint("wait\nfly 1 2") ==
          "tour.txt: line 2: is no event: move, down, up, click, drag, wheel, key, text, frames, wait, drop "
          "and focus are "
          "(fly)");
    CHECK(complaint("move 1") == "tour.txt: line 1: needs a place's Y");
    CHECK(complaint("move 1 x") == "tour.txt: line 1: needs a place's Y (x)");
    CHECK(complaint("move nan 1").starts_with("tour.txt: line 1: needs a place"));
    CHECK(complaint("move 1e30 1").starts_with("tour.txt: line 1: needs a place"));
    CHECK(complaint("down sideways") == "tour.txt: line 1: needs a button: left, right or middle (sideways)");
    CHECK(complaint("key Hyper+Q").starts_with("tour.txt: line 1: needs a key"));
    CHECK(complaint("key").starts_with("tour.txt: line 1: needs a key"));
    CHECK(complaint("text hello").starts_with("tour.txt: line 1: needs a text in double quotes"));
    CHECK(complaint("text \"hello").starts_with("tour.txt: line 1: has a text without its closing quote"));
    CHECK(complaint("frames -3").starts_with("tour.txt: line 1: needs a number of frames"));
    CHECK(complaint("frames 99999999999").starts_with("tour.txt: line 1: needs a number of frames"));
    CHECK(complaint("wait now") == "tour.txt: line 1: has more than its event needs (now)");
    CHECK(complaint("click \"\"").starts_with("tour.txt: line 1: has an empty widget name"));
    CHECK(complaint("click \"a\":").starts_with("tour.txt: line 1: needs a fraction"));
    CHECK(complaint("move \"Canvas\":@").starts_with("tour.txt: line 1: needs a polar angle"));
    CHECK(complaint("move \"Canvas\":@30,north") == "tour.txt: line 1: needs an azimuth (north)");
    CHECK(complaint("") == "none");
}

TEST_CASE("keys: names and modifiers") {
    CHECK(ui::parse_key("Ctrl++") == ui::KeyPress{'+', true, false, false});
    CHECK(ui::parse_key("a") == ui::KeyPress{'A', false, false, false});
    CHECK(ui::parse_key("Alt+F12") == ui::KeyPress{301, false, false, true});
    CHECK(ui::parse_key("Escape") == ui::KeyPress{256, false, false, false});
    CHECK(!ui::parse_key(""));
    CHECK(!ui::parse_key("Ctrl+"));
    CHECK(!ui::parse_key("Ctrl+Nothing"));
}
