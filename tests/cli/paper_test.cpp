#include <doctest/doctest.h>
#include <signal.h>

#include <filesystem>

#include "core/image/picture.h"
#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/stopping.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

TEST_CASE("paper writes its page with the pictures beside it") {
    const TemporaryFolder folder;
    const std::string out = folder / "deep/paper";
    CHECK(answer({"paper", "-o", out, "--size", "48x32", "--only", "figure-9", "--only", "figure-6"})
              .starts_with("4 pictures and index.html"));
    CHECK(std::distance(fs::directory_iterator(out), {}) == 5);
    const std::string page = read_all(fs::path(out) / "index.html");
    for (const char* name :
         {"figure-9-across.png", "figure-9-along.png", "figure-6-x.svg", "figure-6-y.svg"}) {
        CHECK(page.find("src=\"" + std::string(name) + "\"") != std::string::npos);
        CHECK(fs::exists(fs::path(out) / name));
    }
    // In the order of the paper, whatever was asked for first.
    CHECK(page.find("id=\"figure-6\"") < page.find("id=\"figure-9\""));
    CHECK(page.find("id=\"figure-5\"") == std::string::npos);
    const Raster across = load_picture(fs::path(out) / "figure-9-across.png", "", "", PictureShape::any);
    CHECK(across != load_picture(fs::path(out) / "figure-9-along.png", "", "", PictureShape::any));
    // Once more in its place.
    answer({"paper", "-o", out, "--size", "48x32", "--only", "figure-9"});
    CHECK(read_all(fs::path(out) / "index.html").find("id=\"figure-6\"") == std::string::npos);
}

TEST_CASE("a paper that cannot be made leaves nothing behind") {
    const TemporaryFolder folder;
    write_all(folder / "file", "kept");
    const Finished finished = run_cli({"paper", "-o", folder / "file", "--only", "figure-9"});
    CHECK(finished.code == 1);
    CHECK_MESSAGE(is_one_line_with(finished.err, {"file: write: "}), finished.err);
    CHECK(read_all(folder / "file") == "kept");
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"paper"},
                                                      {"paper", "-o", "-"},
                                                      {"paper", "-o", folder / "out", "--only", "figure-2"},
                                                      {"paper", "-o", folder / "out", "--size", "0x0"}})
        CHECK(run_cli(arguments).code == 2);
    CHECK(folder.size() == 1);
}

TEST_CASE("Ctrl+C ends the paper within a second and leaves no folder") {
    const TemporaryFolder folder;
    for (const double after : {0.7, 3.0}) {
        check_stops_within_a_second({"paper", "-o", folder / "paper"},
                                    {.signal = SIGINT, .signal_after = after});
        CHECK(folder.size() == 0);
    }
}
