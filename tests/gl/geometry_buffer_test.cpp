// What the geometry pass draws, read back, against closed forms.
#include "app/preview/geometry_buffer.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/headless/offscreen_context.h"
#include "app/preview/preview.h"
#include "core/bake/bake.h"
#include "core/formats/obj_file.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr glm::ivec2 size{300, 240};

bool is_frame(const glm::dmat3& frame) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::abs(glm::dot(frame[i], frame[j]) - (i == j)) > 1e-5) return false;
    return glm::dot(glm::cross(frame[0], frame[1]), frame[2]) > 0;
}

// Calls see(point) for each pixel that shows the object; returns how many do.
template <class See>
int each_point(const SurfaceImage& image, const See& see) {
    int count = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (const auto point = image.at({x + 0.5, y + 0.5})) {
                see(*point);
                ++count;
            }
    return count;
}

}  // namespace

TEST_CASE("geometry buffer: the torus is seen where its equation says, with its gradient") {
    const auto context = make_offscreen_context({16, 16});
    GeometryBuffer buffer;
    Scene scene;
    scene.object = make_object("torus");
    scene.yaw = 30;
    scene.pitch = -15;
    CHECK(buffer.update(scene, size));
    const glm::dmat3 view = object_to_view(scene);
    const SurfaceImage image = buffer.read();
    double off = 0;
    int tilted = 0;
    const int seen = each_point(image, [&](const SurfacePoint& point) {
        CHECK(is_frame(point.frame));
        const glm::dvec3 p = point.position * view, n = point.frame[2] * view;
        const double r = std::hypot(p.x, p.z), tube = 0.36, ring = 1 - tube;
        const glm::dvec3 gradient((r - ring) * p.x / r, p.y, (r - ring) * p.z / r);
        off = std::max(off, std::abs(glm::length(gradient) - tube));
        tilted += glm::length(n - glm::normalize(gradient)) > 0.02;
    });
    CHECK(seen > 10000);
    CHECK(off < 1.5 / pixels_per_unit(scene, size));  // at the outline a texel shows its neighbour's point
    CHECK(tilted < 0.01 * seen);                      // and there alone the normal turns within a texel
}

TEST_CASE("geometry buffer: every object has frames that face the viewer, at any view") {
    const auto context = make_offscreen_context({16, 16});
    GeometryBuffer buffer;
    Scene scene;
    for (const std::string& name : object_names()) {
        scene.object = make_object(name);
        for (const double yaw : {0.0, 130.0}) {
            CAPTURE(name);
            scene.yaw = yaw;
            scene.pitch = yaw / 3;
            buffer.update(scene, size);
            int wrong = 0;
            const int seen = each_point(buffer.read(), [&](const SurfacePoint& point) {
                wrong += !is_frame(point.frame) || point.frame[2].z <= 0;
            });
            CHECK(seen > 3000);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("geometry buffer: it is drawn anew only when what is seen changes") {
    const auto context = make_offscreen_context({16, 16});
    GeometryBuffer buffer;
    Scene scene;
    scene.object = make_object("plate");
    CHECK(buffer.update(scene, size));
    scene.light.phi += 10;
    scene.exposure = 1;
    CHECK(!buffer.update(scene, size));
    scene.yaw = 1;
    CHECK(buffer.update(scene, size));
    CHECK(buffer.update(scene, size / 2));
    scene.object = {};
    CHECK(buffer.update(scene, size));
    CHECK(!buffer.update(scene, size));
    // What the sphere hides of a mesh's smaller picture is drawn to its corners.
    CHECK(each_point(buffer.read(), [](const SurfacePoint&) {}) ==
          doctest::Approx(3.14159265 * std::pow(pixels_per_unit(scene, size), 2)).epsilon(5e-3));
}

TEST_CASE("geometry buffer: coverage adds up to the area, finer than whole texels") {
    const auto context = make_offscreen_context({16, 16});
    GeometryBuffer buffer;
    Scene scene;
    // A square that is turned a little, so that its edges cross texels anyhow.
    scene.object.mesh = std::make_shared<const Mesh>(
        parse_obj("v 0.6 0.5 0\nv -0.5 0.6 0\nv -0.6 -0.5 0\nv 0.5 -0.6 0\nf 1 2 3 4\n", "square"));
    buffer.update(scene, size);
    const double unit = pixels_per_unit(scene, size);
    std::vector<float> texels(static_cast<std::size_t>(size.x * size.y) * 4);
    buffer.normals().bind(0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
    double area = 0;
    int parts = 0;
    for (std::size_t i = 3; i < texels.size(); i += 4) {
        area += static_cast<double>(texels[i]);
        parts += texels[i] > 0 && texels[i] < 1;
    }
    CHECK(area == doctest::Approx(2 * unit * unit).epsilon(1e-3));  // a square of diagonal 2
    CHECK(parts > 100);
}

TEST_CASE("a background is shown as it is named at every exposure") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    preview.set(bake(design_of(GgxLobe{0.3, 0.3}), {.quality = Quality::draft}));
    Scene scene;
    const auto corner = [&](Background background, double exposure) {
        scene.background = background;
        scene.exposure = exposure;
        return static_cast<double>(preview.picture(scene, {32, 32}, 1, false)[0]);
    };
    for (const double exposure : {-2.0, 0.0, 3.0}) {
        CHECK(corner(Background::white, exposure) == doctest::Approx(1).epsilon(4e-3));
        CHECK(corner(Background::black, exposure) < 3e-3);
        CHECK(corner(Background::grey, exposure) == doctest::Approx(0.4613).epsilon(1e-2));  // 18 % in sRGB
    }
    scene.background_colour = {0.5, 0.1, 0.02};
    CHECK(corner(Background::custom, 1) == doctest::Approx(0.7354).epsilon(1e-2));
    CHECK(corner(Background::wall, 1) > 1.2 * corner(Background::wall, 0));
}
