// Choosing what the surface is shown on.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "app/preview/probe.h"
#include "core/paint/raster_texels.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;

namespace {

constexpr const char* tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 3 2 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string written(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
    return file.string();
}

}  // namespace

TEST_CASE("objects: a click shows the object from its first view and moves no light") {
    test::Rig r;
    const Scene before = r.designer().scene;
    r.designer().scene.yaw = 40;
    r.play("click \"Torus\"\nwait");
    CHECK(r.designer().scene.object.name == "torus");
    CHECK(r.designer().scene.object.mesh);
    CHECK(r.designer().scene.yaw == 0);
    CHECK(r.designer().scene.light == before.light);
    r.play("click \"Plate\"\nclick \"Sphere\"\nwait");
    CHECK(r.designer().scene == before);
}

TEST_CASE("objects: an OBJ file dropped on the window is shown, and a bad one told") {
    const test::TemporaryFolder folder;
    test::Rig r;
    r.play("drop \"" + written(folder.path() / "Mine.OBJ", tetrahedron) + "\"\nwait");
    REQUIRE(r.designer().scene.object.mesh);
    CHECK(r.designer().scene.object.mesh->indices.size() == 12);
    CHECK(!r.designer().pictures.talking());
    CHECK(r.designer().files.message().empty());
    r.play("drop \"" + written(folder.path() / "less.obj", std::string(tetrahedron) + "f 1 2\n") +
           "\"\nwait\nframes 2");
    CHECK(r.designer().files.message() == "less.obj: faces of fewer than 3 corners left out: 1");
    const SceneObject mine = r.designer().scene.object;
    r.play("drop \"" + written(folder.path() / "bad.obj", "v 0 0 0\nf 1 2 3\n") + "\"\nwait");
    CHECK(r.designer().objects.talking());
    CHECK(r.designer().scene.object == mine);
    r.play("click \"OK\"\nframes 2");
    CHECK(!r.designer().objects.talking());
    r.play("click \"OBJ file\"\nframes 2");
    CHECK(r.designer().objects.talking());
    r.play("click \"Cancel\"\nframes 2");
    CHECK(!r.designer().objects.talking());
}

TEST_CASE("objects: paint on the torus lands on the half vector of what is pointed at") {
    test::Rig r(2);
    r.play("click \"Torus\"\nwait\nclick \"Paint\"");
    const Scene scene = r.designer().scene;
    r.play("drag \"Preview\":0.3,0.45 \"Preview\":0.35,0.4 8");
    CHECK(r.designer().scene == scene);
    REQUIRE(r.layers().size() == 2);
    const Raster& raster = *std::get<PaintedLobe>(r.layers()[1].lobe).image.raster;
    const ImVec4 box = r.stage.items().rectangle("Preview").value();
    const glm::ivec2 size(int(box.z - box.x), int(box.w - box.y));
    const SurfaceImage& surface = r.designer().preview.surface(scene, size);
    for (const double t : {0.0, 0.5, 1.0}) {
        const auto h =
            half_vector(scene, surface, glm::dvec2(size) * glm::dvec2(0.3 + 0.05 * t, 0.45 - 0.05 * t));
        REQUIRE(h);
        CHECK(raster_value(raster.values, raster.width, disk_point(*h)) > 0.4);
    }
    // Beside the object and in its hole nothing is pointed at.
    CHECK(!half_vector(scene, surface, glm::dvec2(size) * 0.5));
    CHECK(!half_vector(scene, surface, {2, 2}));
}
