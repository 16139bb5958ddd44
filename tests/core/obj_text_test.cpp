// OBJ files: how their text may be written, and what is refused of it.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <string_view>

#include "tests/core/obj_text.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

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

TEST_CASE("obj: what is wrong is told with its line") {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    CHECK(obj_refusal("") == "test.obj: read: the file holds no surface");
    CHECK(obj_refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").find("holds no surface") != std::string::npos);
    CHECK(obj_refusal("v 0 0 0\nv 1 0 0\n\nf 1 2 3\n") ==
          "test.obj: line 4: a face names a vertex that the file does not have (3 of 2)");
    CHECK(
        obj_refusal("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 -4\r\n").find("line 4: a face names a vertex") !=
        std::string::npos);
    for (const char* const index : {"0", "4", "-4", "99999999999", "-99999999999", "99999999999999999999"}) {
        CAPTURE(index);
        CHECK(obj_refusal(three + "f 1 2 \\\n " + index + "\n").find("test.obj: line ") == 0);
        CHECK(obj_refusal(three + "f 1 2 " + index + "\n").find("line 4: a face names a vertex") !=
              std::string::npos);
    }
    for (const char* const corner : {"a", "1.5", "1/a", "1/2/3/4", "/1", "//1", "0x1", "1,2", "--1"}) {
        CAPTURE(corner);
        CHECK(obj_refusal(three + "f 1 2 " + corner + "\n") ==
              fmt::format(
                  "test.obj: line 4: a face's corner must be v, v/vt, v//vn or v/vt/vn, each an index ({})",
                  corner));
    }
    for (const char* const number : {"abc", "nan", "NaN", "-nan", "inf", "-Infinity", "1e999", "1.#IND",
                                     "0x1p3", "1..2", "1e", "--1", "+-1", "1d3"}) {
        CAPTURE(number);
        CHECK(obj_refusal(fmt::format("v 0 0 0\nv 1 {} 0\n", number)) ==
              fmt::format("test.obj: line 2: a vertex must be of finite numbers ({})", number));
        CHECK(obj_refusal(fmt::format("\nvn 1 {} 0\n", number)).find("line 2: a normal must be of finite") !=
              std::string::npos);
        CHECK(obj_refusal(fmt::format("\nvt 1 {}\n", number)).find("line 2: a texture coordinate must be") !=
              std::string::npos);
        CHECK(obj_refusal(fmt::format("v 0 0 0 {}\n", number)).find("line 1: a vertex must be") !=
              std::string::npos);
    }
    CHECK(obj_refusal("v 0,5 0,5 0,5\n") ==
          "test.obj: line 1: a vertex must be of finite numbers with decimal points (0,5)");
    CHECK(obj_refusal("v 0 0 \\\n x\n").find("line 2: a vertex must be") !=
          std::string::npos);  // where it stands
    CHECK(obj_refusal("v 1 2\n") == "test.obj: line 1: a vertex must have 3 numbers (2)");
    CHECK(obj_refusal("v 1 2 # 3\n") == "test.obj: line 1: a vertex must have 3 numbers (2)");
    CHECK(obj_refusal("\nvn 1 2\n") == "test.obj: line 2: a normal must have 3 numbers (2)");
    CHECK(obj_refusal("vt\n") == "test.obj: line 1: a texture coordinate must have 1 numbers (0)");
    CHECK(obj_refusal("v 1e101 0 0\n") ==
          "test.obj: line 1: a vertex must be of numbers up to 1e+100 (1e101)");
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
                CHECK(obj_refusal(text) ==
                      fmt::format("test.obj: read: an OBJ file must be UTF-8 or ASCII (UTF-{})", 8 * width));
            }
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
