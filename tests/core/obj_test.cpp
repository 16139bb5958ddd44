// OBJ files: what they may hold, and what is refused.
#include "core/exchange/obj_file.h"

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <string_view>

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

TEST_CASE("obj: lines are continued, commented, ended and marked as the format allows") {
    const Mesh expected = parse_obj(cube, "cube");
    const auto replaced = [](std::string text, std::string_view what, std::string_view by) {
        for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
            text.replace(at, what.size(), by);
        return text;
    };
    const std::string text = cube;
    CHECK(parse_obj("\xef\xbb\xbf" + text, "mark") == expected);
    CHECK(parse_obj("\xef\xbb\xbf" + text.substr(text.find("v ")), "mark before a vertex") == expected);
    CHECK(parse_obj(replaced(text, "\n", "\r\n"), "CR LF") == expected);
    CHECK(parse_obj(replaced(text, "\n", "\r"), "CR") == expected);
    CHECK(parse_obj(replaced(text, "f 1 2", "f 1 \\\n 2"), "continued") == expected);
    CHECK(parse_obj(replaced(text, "f 1 2", "f 1\\\r\n2"), "continued, CR LF") == expected);
    CHECK(parse_obj(replaced(text, " ", " \\ \n\t"), "every word on a line") == expected);
    CHECK(parse_obj(replaced(text, "\n", " # f 1 2 3 \\\n"), "comments") == expected);
    CHECK(parse_obj(replaced(text, "\n", "# 0,5\n"), "comments without a blank") == expected);
    CHECK(parse_obj(replaced(text, "\n", "  \t\n\n"), "blanks") == expected);
    CHECK(parse_obj(text.substr(0, text.size() - 1), "no last line's end") == expected);
    CHECK(parse_obj(text + "f 1 2 \\", "continued into nothing") == parse_obj(text + "f 1 2", "the same"));
    CHECK(parse_obj(replaced(text, "v 1 ", "v +1.0e0 "), "signs and exponents") == expected);
    CHECK(parse_obj(replaced(text, "f ", "fo "), "the old name of faces") == expected);
    CHECK(parse_obj(text + std::string(1 << 20, '#') + "\n" + std::string(1 << 20, ' ') + "usemtl none\n",
                    "long lines") == expected);
    CHECK(parse_obj("x y z\nvp 1 2\ns off\nusemtl a b\nlod 3\n" + text, "unknown statements") == expected);
}

TEST_CASE("obj: vertices may have a weight or a colour, and stand below the faces") {
    const Mesh expected = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "three");
    CHECK(parse_obj("v 0 0 0 1\nv 1 0 0 0.5\nv 0 1 0 2\nf 1 2 3\n", "weights") == expected);
    CHECK(parse_obj("v 0 0 0 1 0 0\nv 1 0 0 0 .5 0\nv 0 1 0 0 0 1.\nf 1 2 3\n", "colours") == expected);
    CHECK(parse_obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "faces first") == expected);
    CHECK(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .5\nvt 1 1 1\nf 1/1 2/2/ 3//\n", "parts").positions ==
          expected.positions);
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
    CHECK(refusal("v 0 0 0\nv 1 0 0\nl 1 2\n") ==
          "test.obj: read: the file holds no surface (points and lines left out: 1)");
    // A corner that is named twice in a row is one.
    CHECK(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2 3 3\n", "twice") ==
          parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "once"));
}

TEST_CASE("obj: what is wrong is told with its line") {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    CHECK(refusal("") == "test.obj: read: the file holds no surface");
    CHECK(refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").find("holds no surface") != std::string::npos);
    CHECK(refusal("v 0 0 0\nv 1 0 0\n\nf 1 2 3\n") ==
          "test.obj: line 4: a face names a vertex that the file does not have (3 of 2)");
    CHECK(refusal("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 -4\r\n").find("line 4: a face names a vertex") !=
          std::string::npos);
    for (const char* const index : {"0", "4", "-4", "99999999999", "-99999999999", "99999999999999999999"}) {
        CAPTURE(index);
        CHECK(refusal(three + "f 1 2 \\\n " + index + "\n").find("test.obj: line ") == 0);
        CHECK(refusal(three + "f 1 2 " + index + "\n").find("line 4: a face names a vertex") !=
              std::string::npos);
    }
    for (const char* const corner : {"a", "1.5", "1/a", "1/2/3/4", "/1", "//1", "0x1", "1,2", "--1"}) {
        CAPTURE(corner);
        CHECK(refusal(three + "f 1 2 " + corner + "\n") ==
              fmt::format(
                  "test.obj: line 4: a face's corner must be v, v/vt, v//vn or v/vt/vn, each an index ({})",
                  corner));
    }
    for (const char* const number : {"abc", "nan", "NaN", "-nan", "inf", "-Infinity", "1e999", "1.#IND",
                                     "0x1p3", "1..2", "1e", "--1", "+-1", "1d3"}) {
        CAPTURE(number);
        CHECK(refusal(fmt::format("v 0 0 0\nv 1 {} 0\n", number)) ==
              fmt::format("test.obj: line 2: a vertex must be of finite numbers ({})", number));
        CHECK(refusal(fmt::format("\nvn 1 {} 0\n", number)).find("line 2: a normal must be of finite") !=
              std::string::npos);
        CHECK(refusal(fmt::format("\nvt 1 {}\n", number)).find("line 2: a texture coordinate must be") !=
              std::string::npos);
        CHECK(refusal(fmt::format("v 0 0 0 {}\n", number)).find("line 1: a vertex must be") !=
              std::string::npos);
    }
    CHECK(refusal("v 0,5 0,5 0,5\n") ==
          "test.obj: line 1: a vertex must be of finite numbers with decimal points (0,5)");
    CHECK(refusal("v 0 0 \\\n x\n").find("line 2: a vertex must be") !=
          std::string::npos);  // where it stands
    CHECK(refusal("v 1 2\n") == "test.obj: line 1: a vertex must have 3 numbers (2)");
    CHECK(refusal("v 1 2 # 3\n") == "test.obj: line 1: a vertex must have 3 numbers (2)");
    CHECK(refusal("\nvn 1 2\n") == "test.obj: line 2: a normal must have 3 numbers (2)");
    CHECK(refusal("vt\n") == "test.obj: line 1: a texture coordinate must have 1 numbers (0)");
    CHECK(refusal("v 1e101 0 0\n") == "test.obj: line 1: a vertex must be of numbers up to 1e+100 (1e101)");
    const TemporaryFolder folder;
    CHECK(user_error_of([&] { load_obj(folder.path() / "none.obj"); }).find("cannot be read") !=
          std::string::npos);
}

TEST_CASE("obj: text of wider characters is refused by its name") {
    for (const std::size_t width : {2u, 4u})
        for (const bool big : {false, true})
            for (const bool mark : {false, true}) {
                std::string text;
                const auto add = [&](char32_t unit) {
                    for (std::size_t i = 0; i < width; ++i)
                        text += static_cast<char>(unit >> 8 * (big ? width - 1 - i : i) & 0xff);
                };
                if (mark) add(0xfeff);
                for (const char letter : std::string(cube)) add(static_cast<unsigned char>(letter));
                CHECK(refusal(text) ==
                      fmt::format("test.obj: read: an OBJ file must be UTF-8 or ASCII (UTF-{})", 8 * width));
            }
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
    CHECK(refusal(many) == "test.obj: line 4: the file holds too many triangles (more than 2000000)");
}

TEST_CASE("obj: bytes at random are refused or read, and never more") {
    std::mt19937 random(5);
    const std::string letters = "vnftogls/ -.0123456789e\n\n\r\t\\#,";
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
