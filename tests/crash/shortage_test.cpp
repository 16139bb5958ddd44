// What is missing or short is a message, not the end of the program.
#include <doctest/doctest.h>
#include <stdio.h>
#include <sys/wait.h>

#include <array>
#include <string>

#include "core/image/image_file.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

struct Outcome {
    int status = -1;
    std::string told;
};

Outcome run(const fs::path& program, const std::string& arguments) {
    Outcome outcome;
    FILE* const pipe = popen(("'" + program.string() + "' " + arguments + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> bytes{};
    while (const std::size_t got = fread(bytes.data(), 1, bytes.size(), pipe))
        outcome.told.append(bytes.data(), got);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    return outcome;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

// Stripes, so that a stroke changes it.
std::string striped_raster(int side) {
    const std::string width = std::to_string(side);
    std::string text = "{\"width\": " + width + ", \"height\": " + width + ", \"values\": [1";
    for (int i = 1; i < side * side; ++i) text += i % 2 == 0 ? ",1" : ",0";
    return text + "]}";
}

}  // namespace

TEST_CASE("no library for pictures: each use of one is told, and the designer goes on") {
    const TemporaryFolder folder;
    write_image(folder / "picture.png", {8, 8}, std::vector<float>(8 * 8 * 3, 0.5f));
    write_all(folder / "pictured.nacre",
              "{\"nacre\": 1, \"distribution\": {\"layers\": [{\"lobe\": \"painted\", \"image\": "
              "\"picture.png\"}]}}");
    fs::create_directory(folder / "bin");
    for (const char* program : {"nacre-crash-child", "nacre-cli"})
        fs::copy_file(fs::path(NACRE_BINARY_DIR) / program, folder / "bin" / program);
    for (const bool damaged : {false, true}) {
        CAPTURE(damaged);
        if (damaged) write_all(folder / "bin/libnacre-pictures.so", "no library");
        const Outcome designer =
            run(folder / "bin/nacre-crash-child", "without-pictures '" + folder.path().string() + "'");
        CHECK_MESSAGE(designer.status == 0, designer.told);
        CHECK_MESSAGE(count(designer.told, " libnacre-pictures.so, which") +
                              count(designer.told, "libnacre-pictures.so: file too short") ==
                          6,
                      designer.told);
        CHECK(count(designer.told, "\n") == 6);
        const Outcome line =
            run(folder / "bin/nacre-cli", "info '" + (folder / "pictured.nacre").string() + "'");
        CHECK(line.status == 1);
        CHECK(count(line.told, "libnacre-pictures.so") >= 1);
        CHECK(count(line.told, "\n") == 1);
    }
}

#ifndef NACRE_SANITIZED  // whose shadow memory needs more than the limit
TEST_CASE("too little memory: opening, painting and exporting are told, and the designer goes on") {
    const TemporaryFolder folder;
    const std::string painted = "{\"lobe\": \"painted\", \"image\": " + striped_raster(1024) + "}";
    write_all(folder / "large.nacre",
              "{\"nacre\": 1, \"distribution\": {\"layers\": [{\"lobe\": \"gaussian\"}, " + painted + "]}}");
    const Outcome designer =
        run(fs::path(NACRE_CRASH_CHILD), "without-memory '" + folder.path().string() + "'");
    CHECK_MESSAGE(designer.status == 0, designer.told);
    for (const char* what : {"open", "stroke", "export"})
        CHECK_MESSAGE(count(designer.told, std::string(what) + ": ") == 1, designer.told);
    CHECK(count(designer.told, "\n") == 3);
    for (const char* what : {"open", "export"})  // OpenGL has its own words
        CHECK(designer.told.find(std::string(what) + ": there is not enough memory for this") !=
              std::string::npos);
}
#endif
