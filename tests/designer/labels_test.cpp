// Names of files stand whole in the window, whatever they mean to Dear ImGui; tests/ui/labels_test.cpp has
// the panels.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "core/image/image_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr const char* odd_names[] = {"a##b", "y###", "%s%n", "100%"};

}  // namespace

TEST_CASE("labels: a design, its layer, an environment map and an object of odd names") {
    for (const std::string name : odd_names) {
        CAPTURE(name);
        const TemporaryFolder folder;
        Rig r(2);
        const auto has = [&](const std::string& item) { return r.stage.items().rectangle(item).has_value(); };
        const auto drop = [&](const std::string& file) {
            r.play("drop \"" + (folder / file).string() + "\"\nframes 3");
        };
        Design design = starter_design();
        design.name = name;
        design.distribution.layers[0].name = name;
        save_design(design, folder / (name + ".nacre"));
        drop(name + ".nacre");
        CHECK(r.document().design == design);
        CHECK(r.designer().files.message() == "Opened " + name + ".nacre");
        write_image(folder / (name + ".exr"), {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
        drop(name + ".exr");
        r.play(
            "click \"As Environment map\"\nclick \"Import\"\nwait\nclick \"Light\"\nclick "
            "\"Environment\"\nframes 3");
        CHECK(has(name + ".exr"));
        r.play(
            "key Escape\nframes 3\nclick \"Compare\"\nclick \"Take snapshot\"\nframes 3\nclick "
            "\"Left\"\nframes 3");
        CHECK(has("A: " + name));
        r.play("key Escape\nframes 3");
        write_all(folder / (name + ".obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        drop(name + ".obj");
        r.play("wait\nframes 3");
        const auto button = r.stage.items().rectangle("OBJ file");
        REQUIRE(button);
        const float text = ImGui::CalcTextSize((name + ".obj").c_str()).x;
        CHECK(button->z - button->x == doctest::Approx(text + 2 * ImGui::GetStyle().FramePadding.x));
    }
}

TEST_CASE("labels: a recent file is as broad in its menu as its name") {
    Rig r;
    const std::string name = "a##" + std::string(40, 'b') + ".nacre";
    r.designer().recent.note("/designs/" + name);
    r.play("click \"File\"\nframes 5\nclick \"Open recent\"\nframes 5");
    const auto entry = r.stage.items().rectangle("Recent 1");
    REQUIRE(entry);
    CHECK(entry->z - entry->x > ImGui::CalcTextSize(name.c_str()).x);
}
