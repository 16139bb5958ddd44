// OBJ files: what they may hold, and what is refused.
#include "core/exchange/obj_file.h"

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <random>

#include "core/geometry/shapes.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

const char* const cube =
    "# a cube, one face with negative indices\n"
    "o box\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "g lower\nf 4 3 2 1\nf -4 -3 -2 -1\n"
    "g sides\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

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

std::string refusal(const std::string& text) {
    return user_error_of([&] { parse_obj(text, "test.obj"); });
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

TEST_CASE("obj: what is wrong is told with its line") {
    CHECK(refusal("").find("holds no surface") != std::string::npos);
    CHECK(refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").find("holds no surface") != std::string::npos);
    CHECK(refusal("v 0 0 0\nv 1 0 0\n\nf 1 2 3\n").find("test.obj: line 4: a face names a vertex") == 0);
    CHECK(refusal("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 -4\r\n").find("line 4: a face names a vertex") !=
          std::string::npos);
    CHECK(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n").find("line 4: a face names a normal") !=
          std::string::npos);
    CHECK(refusal("v 0 0 0\nv 1 0 0\nf 1 2\n").find("line 3: a face must have 3") != std::string::npos);
    CHECK(refusal("v 0 0 0\nv 1e999 0 0\n").find("line 2: a vertex must be of finite numbers") !=
          std::string::npos);
    std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 300; ++i) many += " 1";
    CHECK(refusal(many).find("line 4: a face must have") != std::string::npos);
    const TemporaryFolder folder;
    CHECK(user_error_of([&] { load_obj(folder.path() / "none.obj"); }).find("cannot be read") !=
          std::string::npos);
}

TEST_CASE("obj: bytes at random are refused or read, and never more") {
    std::mt19937 random(5);
    const std::string letters = "vnftogls/ -.0123456789e\n\n\r\t\\#";
    for (int i = 0; i < 3000; ++i) {
        std::string text = i % 2 ? cube : "";
        for (int k = 0; k < 60; ++k) {
            const auto at = text.empty() ? 0 : random() % text.size();
            const char letter = i % 7 ? letters[random() % letters.size()] : static_cast<char>(random());
            text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), letter);
        }
        try {
            const Mesh mesh = parse_obj(text, "random");
            for (const std::uint32_t index : mesh.indices) REQUIRE(index < mesh.positions.size());
            for (const glm::vec3& p : mesh.positions) REQUIRE(glm::length(p) < 1.001f);
            for (const glm::vec3& n : mesh.normals) REQUIRE(glm::length(n) == doctest::Approx(1));
        } catch (const UserError&) {
        }
    }
}
