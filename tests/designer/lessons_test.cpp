// The lessons of docs/tutorial.md, each played from a cold start on the design that the program begins with:
// in how many steps of the hand, and what shines afterwards.
#include <doctest/doctest.h>

#include <filesystem>

#include "core/image/picture.h"
#include "core/paint/lobe_handles.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/highlight_rig.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

const fs::path lessons = fs::path(NACRE_SOURCE_DIR) / "docs/lessons";

// Clicks, drags, keys, drops and typed texts.
int steps_of(const EventScript& script) {
    int steps = 0;
    for (const Event& event : script.events)
        steps += std::holds_alternative<events::Click>(event.what) ||
                 std::holds_alternative<events::Drag>(event.what) ||
                 std::holds_alternative<events::Key>(event.what) ||
                 std::holds_alternative<events::Drop>(event.what) ||
                 std::holds_alternative<events::Text>(event.what);
    return steps;
}

struct Lesson : test::HighlightRig {
    int steps = 0;

    explicit Lesson(const std::string& name) {
        std::string text = test::read_all(lessons / (name + ".events"));
        if (const std::size_t at = text.find("\"logo.svg\""); at != text.npos)
            text.replace(at + 1, 8, (lessons / "logo.svg").string());
        const EventScript script = parse_events(text, name);
        steps = steps_of(script);
        stage.play(script);
        look();
    }
};

}  // namespace

TEST_CASE("lesson: a smiley, upright, in four steps") {
    Lesson lesson("smiley");
    CHECK(lesson.steps <= 4);
    // The face is as broad as the brush: 0.43 of it to an eye, half of it to the mouth.
    const double radius = lesson.canvas().brush.radius;
    REQUIRE(radius > 15);
    const double eye_x = 0.32 * radius, eye_y = 0.28 * radius;
    const double face = lesson.shines(-eye_x, eye_y), plain = lesson.shines(0, 0);
    CHECK(face > 1.5 * plain);
    CHECK(lesson.shines(eye_x, eye_y) > 1.5 * plain);
    CHECK(lesson.shines(0, -0.5 * radius) > 1.5 * plain);
    CHECK(lesson.shines(0, 0.5 * radius) < 1.2 * plain);
}

TEST_CASE("lesson: a core and a haze in three steps") {
    Lesson lesson("core-and-haze");
    CHECK(lesson.steps <= 3);
    REQUIRE(lesson.layers().size() == 2);
    const double core = shape_of(lesson.layers()[0].lobe)->softness;
    CHECK(shape_of(lesson.layers()[1].lobe)->softness > 2 * core);
    CHECK(lesson.shines(0, 0) > 1.5 * lesson.shines(20, 0));
    CHECK(lesson.shines(20, 0) > 1.3 * lesson.shines(60, 0));
}

TEST_CASE("lesson: a streak in four steps") {
    Lesson lesson("streak");
    CHECK(lesson.steps <= 4);
    const double plain = lesson.shines(45, 0);
    CHECK(lesson.shines(0, 25) - plain > 5 * std::abs(lesson.shines(25, 0) - plain));
}

TEST_CASE("lesson: a logo from an SVG in three steps") {
    Lesson lesson("logo");
    CHECK(lesson.steps <= 3);
    REQUIRE(lesson.layers().size() == 2);
    const double radius = lesson.layers()[1].source.value().size;
    // Of the N its left stem, not what is right of it below the diagonal's end.
    CHECK(lesson.shines(-0.27 * radius, 0) > 1.5 * lesson.shines(0, 0.3 * radius));
    CHECK(lesson.shines(-0.05 * radius, 0.05 * radius) > 1.5 * lesson.shines(0, 0.3 * radius));
    // The diagonal goes down to the right, as it is drawn.
    CHECK(lesson.shines(-0.12 * radius, 0.3 * radius) > 1.5 * lesson.shines(0.12 * radius, 0.3 * radius));
}

TEST_CASE("lesson: a velvet of two colours in eight steps, each on its side") {
    Lesson lesson("velvet");
    CHECK(lesson.steps <= 8);
    REQUIRE(lesson.layers().size() == 2);
    CHECK(lesson.layers()[0].tint.x > 5 * lesson.layers()[0].tint.z);
    CHECK(lesson.layers()[1].tint.z > 5 * lesson.layers()[1].tint.x);
    // Facets that are tilted to the right shine on the left.
    const double tilt = lesson.layers()[0].tilt;
    REQUIRE(tilt > 30);
    const glm::dvec3 left = lesson.colour(-tilt, 0), right = lesson.colour(tilt, 0);
    CHECK(left.x > 1.5 * right.x);
    CHECK(right.z > 3 * left.z);
}
