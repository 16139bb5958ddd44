// The first run of the window.
#include <doctest/doctest.h>

#include "tests/designer/kept_work.h"

using namespace nacre;
using namespace nacre::test;

TEST_CASE("welcome: presets first, two hints until they are followed, and none of it at the next run") {
    const TemporaryFolder folder;
    const StageOptions options{.bake_threads = 1, .folders = below(folder), .welcomes = true};
    constexpr const char* paint_hint = "Paint here: B takes a brush, T a stamp";
    {
        Rig r(options);
        r.play("wait\nframes 5");
        const ui::ItemMap& items = r.stage.items();
        CHECK(items.rectangle("Highlight Smiley"));
        CHECK(items.rectangle("Drag the highlight"));
        CHECK(items.rectangle(paint_hint));
        CHECK(!items.rectangle("Show P1"));
        CHECK(!items.rectangle("Left out"));
        r.play("drag \"Preview\":0.45,0.4 \"Preview\":0.6,0.5 5\nframes 3");
        CHECK(!items.rectangle("Drag the highlight"));
        r.play("key B\nclick \"Canvas\":@20,0\nframes 3");
        CHECK(!items.rectangle(paint_hint));
        r.play("click \"Layers\"\nframes 3\nclick \"Layer 1\"\nframes 3");
        CHECK(items.rectangle("Softness"));
        CHECK(items.rectangle("Rotation"));
        CHECK(!items.rectangle("Tilt"));
        r.play("key Ctrl+Shift+X\nframes 3");
        CHECK(items.rectangle("Tilt"));
        CHECK(items.rectangle("Show P1"));
    }
    Rig r(options);
    r.play("wait\nframes 5");
    CHECK(!r.stage.items().rectangle("Highlight Smiley"));
    CHECK(!r.stage.items().rectangle("Drag the highlight"));
    CHECK(r.stage.items().rectangle("Tilt"));
}
