// The environment in the designer: chosen, dropped, turned by hand, and at rest once it is accumulated.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "core/image/image_file.h"
#include "tests/designer/folder_rig.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

struct Rig : test::FolderRig {
    SceneEnvironment& environment() { return designer().scene.environment; }
};

}  // namespace

TEST_CASE("environment: chosen from the list, it stands in for the lights until they are asked for") {
    Rig r;
    r.play("click \"Light\"\nclick \"Environment\"\nclick \"Furnace\"\nwait\nframes 2");
    REQUIRE(r.environment().picture);
    CHECK(r.environment().picture->name == "furnace");
    CHECK(!lights_shine(r.designer().scene));
    CHECK(!r.stage.items().rectangle("Light polar angle"));
    r.play("click \"Keep scene lights\"\nframes 2");
    CHECK(lights_shine(r.designer().scene));
    CHECK(r.stage.items().rectangle("Light polar angle"));
    r.play("click \"Environment\"\nclick \"None\"\nframes 2");
    CHECK(!r.environment().picture);
}

TEST_CASE("environment: a drag on the object turns it where no light shines") {
    Rig r;
    r.play("click \"Light\"\nclick \"Environment\"\nclick \"Octants\"\nwait");
    const LightSource before = r.designer().scene.light;
    r.play("drag \"Preview\":0.4,0.5 \"Preview\":0.6,0.5 4");
    CHECK(r.environment().rotation < -5);
    CHECK(r.designer().scene.light == before);
}

TEST_CASE("environment: the window is in motion while its picture grows, and rests without an environment") {
    Rig r;
    r.play("wait");
    CHECK(!in_motion(r.designer()));
    r.designer().environment.want("furnace");
    CHECK(in_motion(r.designer()));
    r.play("wait\nframes 20");
    CHECK(r.designer().preview.accumulating());
    CHECK(in_motion(r.designer()));
    r.environment().picture.reset();
    r.play("wait\nframes 20");
    CHECK(!in_motion(r.designer()));
}

TEST_CASE("environment: a dropped picture may be the environment map; what cannot be is said in words") {
    Rig r;
    write_image(r.folder / "sky.exr", {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
    r.play(r.drop("sky.exr") + r.import("Environment map"));
    REQUIRE(r.environment().picture);
    CHECK(r.environment().picture->picture.width == 16);
    write_image(r.folder / "square.exr", {8, 8}, std::vector<float>(8 * 8 * 3, 0.5f));
    r.play(r.drop("square.exr") + r.import("Environment map"));
    CHECK(r.environment().picture->picture.width == 16);
    CHECK(r.designer().pictures.talking());
    r.play("move \"As Environment map\"\nframes 60");
    CHECK(r.stage.items().tooltip() == "8 x 8 pixels, must be twice as wide as high.");
    r.play("key Escape\nframes 2");
    CHECK(!r.designer().pictures.talking());
}
