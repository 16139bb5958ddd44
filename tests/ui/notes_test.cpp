// What is said of a picture is broken into lines between words.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/ui/panel_rig.h"
#include "ui/widgets.h"

using namespace nacre;

TEST_CASE("notes: lines break at blanks, never within a number") {
    // On a line of its own each number begins with what fits no more behind the words before.
    for (std::size_t letters = 1; letters < 60; ++letters) {
        const std::string start(letters, 'm');
        const std::vector<std::string> split = {start + " 0.8476"}, joined = {start + " 0:8476"};
        float height[2] = {};
        int which = 0;
        for (const auto* notes : {&split, &joined}) {
            PanelRig rig([&] {
                ui::notes_row(*notes);
                height[which] = ImGui::GetItemRectSize().y;
            });
            rig.frame();
            ++which;
        }
        CAPTURE(letters);
        CHECK(height[0] == height[1]);
    }
}

TEST_CASE("notes: each is shown whole, and found by its text") {
    const std::vector<std::string> notes = {"one", "", " two  words ", "\xff"};
    PanelRig rig([&] { ui::notes_row(notes); });
    CHECK(rig.has("one"));
    CHECK(rig.has(" two  words "));
}
