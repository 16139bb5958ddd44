// OBJ files: the surfaces that they become.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>

#include "core/geometry/shapes.h"
#include "tests/core/obj_text.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::string text_of(const Mesh& mesh, bool normals) {
    std::string text = "mtllib none.mtl\n";
    for (const glm::vec3& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const glm::vec3& n : mesh.normals) text += fmt::format("vn {} {} {}\n", n.x, n.y, n.z);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        text += "f";
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t index = mesh.indices[i + k] + 1;
            text += normals ? fmt::format(" {}//{}", index, index) : fmt::format(" {}", index);
        }
        text += "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("obj: a cube of several groups, with negative indices and quads, is six flat faces") {
    const Mesh mesh = parse_obj(cube, "cube");
    CHECK(mesh.indices.size() == 36);
    CHECK(mesh.positions.size() == 24);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i], n = mesh.normals[i];
        CHECK(glm::length(p) == doctest::Approx(1));
        CHECK(glm::dot(p, n) == doctest::Approx(1 / std::sqrt(3.0)));  // outward
        CHECK(mesh.tangents[i] == glm::vec3(0));
    }
}

TEST_CASE("obj: a torus comes back as it went, and its normals can be made anew") {
    const Mesh before = torus();
    const Mesh after = parse_obj(text_of(before, true), "torus");
    // Triangles keep their order; vertices are merged and put in the order of the faces.
    REQUIRE(after.indices.size() == before.indices.size());
    float worst = 0;
    for (std::size_t i = 0; i < before.indices.size(); ++i) {
        worst = std::max(
            worst, glm::length(after.positions[after.indices[i]] - before.positions[before.indices[i]]));
        worst =
            std::max(worst, glm::length(after.normals[after.indices[i]] - before.normals[before.indices[i]]));
    }
    CHECK(worst < 1e-5f);
}

TEST_CASE("obj: normals that are missing are those of the surface, where vertices are shared") {
    // An octahedron cut finer and blown up to a sphere: its normal is its point.
    std::string text;
    constexpr int n = 24;
    const double pi = 3.14159265358979;
    text += "v 0 1 0\nv 0 -1 0\n";
    for (int i = 1; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j)
            text += fmt::format("v {} {} {}\n", std::sin(pi * i / n) * std::cos(pi * j / n),
                                std::cos(pi * i / n), std::sin(pi * i / n) * std::sin(pi * j / n));
    const auto at = [](int i, int j) { return 3 + (i - 1) * 2 * n + j % (2 * n); };
    for (int j = 0; j < 2 * n; ++j) {
        text += fmt::format("f 1 {} {}\nf 2 {} {}\n", at(1, j + 1), at(1, j), at(n - 1, j), at(n - 1, j + 1));
        for (int i = 1; i + 1 < n; ++i)
            text += fmt::format("f {} {} {} {}\n", at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
    const Mesh mesh = parse_obj(text, "ball");
    CHECK(mesh.positions.size() == 2 + (n - 1) * 2 * n);
    float least = 1;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        least =
            std::min(least, glm::dot(mesh.normals[i], mesh.positions[i]) / glm::length(mesh.positions[i]));
    CHECK(least > 0.9995f);
}

TEST_CASE("obj: tangents run along u, also where it is mirrored") {
    // Two squares side by side; on the second u runs back.
    const Mesh mesh = parse_obj(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "f 1/1 2/2 3/3 4/4\nf 2/2 5/1 6/4 3/3\n",
        "squares");
    CHECK(mesh.positions.size() == 8);  // the seam stands twice: u turns back there
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float expected = i < 4 ? 1.0f : -1.0f;
        CHECK(mesh.tangents[i].x == doctest::Approx(expected));
        CHECK(mesh.normals[i].z == doctest::Approx(1));
    }
}

TEST_CASE("obj: normals and texture coordinates that the file does not have are made or left out, and told") {
    const Mesh expected = parse_obj(cube, "cube");
    std::string text;
    std::size_t corners = 0;
    for (std::size_t at = 0; at < std::string_view(cube).size(); ++at) {
        text += cube[at];
        const bool index = text.size() > 1 && text.find("\nf") != std::string::npos && std::isdigit(cube[at]);
        if (index) {
            text += "//7";
            ++corners;
        }
    }
    std::string note;
    CHECK(parse_obj(text, "cube", &note) == expected);
    CHECK(note == fmt::format("normals made that the file does not have: {}", corners));
    CHECK(
        parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n", "no direction").normals.at(0) ==
        glm::vec3(0, 0, 1));
    parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/-2 3/3\n", "no uv", &note);
    CHECK(note == "texture coordinates left out that the file does not have: 3");
    parse_obj(cube, "cube", &note);
    CHECK(note.empty());
}

TEST_CASE("obj: what is no polygon is left out and counted") {
    const Mesh expected = parse_obj(cube, "cube");
    std::string note;
    CHECK(parse_obj(std::string(cube) + "f 1 2\nf\nf 1\nf 1 1 2 2\nf 1 2 2 1\n", "small", &note) == expected);
    CHECK(note == "faces of fewer than 3 corners left out: 5");
    CHECK(parse_obj(std::string(cube) + "p 1\nl 1 2 3\nl 1/1 2/2\n", "lines", &note) == expected);
    CHECK(note == "points and lines left out: 3");
    CHECK(parse_obj(
              std::string(cube) + "cstype bezier\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\nf 1 2\n",
              "surface", &note) == expected);
    CHECK(note == "faces of fewer than 3 corners left out: 1; curves and curved surfaces left out: 1");
    CHECK(obj_refusal("v 0 0 0\nv 1 0 0\nl 1 2\n") ==
          "test.obj: read: the file holds no surface (points and lines left out: 1)");
    // A corner that is named twice in a row is one.
    CHECK(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2 3 3\n", "twice") ==
          parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "once"));
}

TEST_CASE("obj: of any size and place it is the same") {
    const Mesh expected = parse_obj(cube, "cube");
    for (const double size : {1e-300, 1e-60, 1e-39, 1e-30, 1e-3, 1e6, 1e30, 1e38, 1e60, 1e96})
        for (const double place : {0.0, 1e3}) {
            std::string text;
            for (int i = 0; i < 8; ++i)
                text +=
                    fmt::format("v {} {} {}\n", (place + (i % 4 == 1 || i % 4 == 2 ? 1 : -1)) * size,
                                (place + (i % 4 >= 2 ? 1 : -1)) * size, (place + (i >= 4 ? 1 : -1)) * size);
            text += std::string(cube).substr(std::string(cube).find("g lower"));
            CAPTURE(size);
            const Mesh mesh = parse_obj(text, "sized");
            REQUIRE(mesh.indices == expected.indices);
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                CHECK(glm::length(mesh.positions[i] - expected.positions[i]) < 1e-6f);
                CHECK(glm::length(mesh.normals[i] - expected.normals[i]) < 1e-6f);
            }
        }
    // What is too small to be told from 0 is 0.
    CHECK(parse_obj("v 1e-400 0 0\nv 1 0.000 -1e-999\nv 0 1 0\nf 1 2 3\n", "tiny") ==
          parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "none"));
}

TEST_CASE("obj: faces of very many corners are polygons too, and their number is bounded") {
    constexpr int n = 20000;
    std::string text = "v 0 0 0\n", face = "f";
    for (int i = 0; i < n; ++i) {
        const double turn = 2 * 3.14159265358979 * i / n, radius = i % 2 ? 1 : 0.5;
        text += fmt::format("v {} {} 0\n", radius * std::cos(turn), radius * std::sin(turn));
        face += fmt::format(" {}", i + 2);
    }
    const Mesh star = parse_obj(text + face + "\n", "star");
    CHECK(star.indices.size() == 3 * (n - 2));
    for (const glm::vec3& normal : star.normals) REQUIRE(normal == glm::vec3(0, 0, 1));
    std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    many += "f";
    for (std::size_t i = 0; i < obj_triangles_max + 3; ++i) many += " 1";
    CHECK(obj_refusal(many) == "test.obj: line 4: the file holds too many triangles (more than 2000000)");
}
