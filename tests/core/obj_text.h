// Texts of OBJ files, read.
#pragma once

#include <string>

#include "core/formats/obj_file.h"
#include "tests/core/user_error_of.h"

namespace nacre::test {

inline constexpr const char* cube =
    "# a cube, one face with negative indices\n"
    "o box\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "g lower\nf 4 3 2 1\nf -4 -3 -2 -1\n"
    "g sides\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// What is told of a text that is none; empty where it is one.
inline std::string obj_refusal(const std::string& text) {
    return user_error_of([&] { parse_obj(text, "test.obj"); });
}

}  // namespace nacre::test
