// Files that are cut short, changed or lie about their size: refused, in silence, and never by what memory
// held.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <functional>
#include <random>

#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> write_every_format(const TemporaryFolder& folder) {
    const FloatImage image = noise({64, 32});
    std::vector<fs::path> files;
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.webp", "a.jp2", "a.heic", "a.ppm", "a.exr"}) {
        files.push_back(folder / name);
        write_picture(files.back(), image);
    }
    for (const char* compression : {"none", "lzw", "packbits", "zip"}) {
        files.push_back(folder / (std::string(compression) + ".tif"));
        write_picture(files.back(), image, {.texts = {{"compression", compression}}});
    }
    for (const char* compression : {"none", "rle", "zips", "piz", "pxr24", "b44", "dwaa"}) {
        files.push_back(folder / (std::string(compression) + ".exr"));
        write_picture(files.back(), image, {.texts = {{"compression", compression}}});
    }
    const std::pair<const char*, std::string> others[] = {{"a.hdr", hdr_file(image, "-Y", "+X")},
                                                          {"a.tga", targa_file(image, false, true, false)},
                                                          {"rle.tga", targa_file(image, false, true, true)},
                                                          {"a.bmp", bmp_file(image, false)},
                                                          {"a.pfm", pfm_file(image)},
                                                          {"a.dds", dds_file(image)},
                                                          {"a.psd", psd_file(image)}};
    for (const auto& [name, bytes] : others) {
        files.push_back(folder / name);
        write_all(files.back(), bytes);
    }
    return files;
}

// What is written to the descriptor of standard error meanwhile.
std::string said_on_stderr(const fs::path& file, const std::function<void()>& action) {
    std::fflush(stderr);
    const int kept = dup(STDERR_FILENO);
    const int diverted = open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    dup2(diverted, STDERR_FILENO);
    action();
    std::fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    close(diverted);
    return read_all(file);
}

// The error, or the numbers, with memory that holds `filling` before it is written.
std::string outcome(const fs::path& file, int filling) {
    mallopt(M_PERTURB, filling);
    std::string result;
    try {
        const ColourPicture picture = load_colours(file);
        result = "picture ";
        result.append(reinterpret_cast<const char*>(picture.colours.data()),
                      picture.colours.size() * sizeof(glm::vec3));
    } catch (const std::exception& error) {
        result = error.what();
    }
    mallopt(M_PERTURB, 0);
    return result;
}

bool is_error(const std::string& outcome) { return !outcome.starts_with("picture "); }

long resident_max() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // KiB
}

}  // namespace

TEST_SUITE_BEGIN("damaged picture");

TEST_CASE("damaged picture: one that is cut short is refused in silence, in every format") {
    const TemporaryFolder folder;
    for (const fs::path& file : write_every_format(folder)) {
        CAPTURE(file.filename().string());
        CHECK(!is_error(outcome(file, 0)));
        const std::string whole = read_all(file);
        const fs::path cut = folder / ("cut" + file.extension().string());
        for (const double part : {0.0, 0.05, 0.25, 0.5, 0.75, 0.95}) {
            CAPTURE(part);
            write_all(cut, std::string_view(whole).substr(
                               0, static_cast<std::size_t>(part * double(whole.size()))));
            std::string found;
            CHECK(said_on_stderr(folder / "said", [&] { found = outcome(cut, 85); }) == "");
            CHECK(is_error(found));
            CHECK(found.find('\n') == std::string::npos);
        }
    }
}

TEST_CASE("damaged picture: changed bytes give an error or the same numbers whatever memory held") {
    const TemporaryFolder folder;
    std::mt19937 random(11);
    for (const fs::path& file : write_every_format(folder)) {
        CAPTURE(file.filename().string());
        const std::string whole = read_all(file);
        const fs::path changed = folder / ("changed" + file.extension().string());
        for (int i = 0; i < 20; ++i) {
            std::string bytes = whole;
            // Half of them where headers and tables stand.
            const std::size_t reach = i % 2 == 0 ? std::min<std::size_t>(whole.size(), 400) : whole.size();
            for (int k = 0; k < 3; ++k) bytes[random() % reach] = static_cast<char>(random());
            write_all(changed, bytes);
            std::string first, second;
            CHECK(said_on_stderr(folder / "said", [&] {
                      first = outcome(changed, 85);
                      // What is kept of the first must not stand in for the second.
                      write_all(changed, bytes + " ");
                      second = outcome(changed, 170);
                  }) == "");
            if (!is_error(first) && !is_error(second)) CHECK(first == second);
        }
    }
}

TEST_CASE("damaged picture: rows of nothing but a claim take no memory") {
    const TemporaryFolder folder;
    const auto big = [](std::uint32_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
        return bytes;
    };
    write_picture(folder / "a.exr", noise({64, 32}));
    std::string exr = read_all(folder / "a.exr");
    // Its data and display windows as large as an environment's may be.
    for (const char* name : {"dataWindow", "displayWindow"}) {
        const std::size_t at = exr.find(name) + std::string(name).size() + 1 + 6 + 4 + 8;
        exr.replace(at, 8, std::string("\xFF\x3F\0\0\xFF\x1F\0\0", 8));
    }
    const std::pair<const char*, std::string> claims[] = {
        {"claim.exr", exr},
        {"claim.webp", "RIFF" + std::string("\x1A\0\0\0", 4) + "WEBPVP8L" + std::string("\x0D\0\0\0", 4) +
                           std::string("\x2F\xFE\xBF\xFF\x07\0\0\0\0\0\0\0\0\0", 14)},
        {"claim.psd", "8BPS" + std::string("\0\1\0\0\0\0\0\0\0\3", 10) + big(8192) + big(16384) +
                          std::string("\0\x08\0\3", 4) + std::string(14, '\0')},
        {"claim.jp2",
         std::string("\xFF\x4F\xFF\x51\0\x2F\0\0", 8) + big(16384) + big(8192) + std::string(24, '\0')},
        {"claim.tga", std::string("\0\0\x0A\0\0\0\0\0\0\0\0\0\0\x40\0\x20\x18\0", 18)}};
    const long before = resident_max();
    for (const auto& claim : claims) {
        CAPTURE(claim.first);
        const std::filesystem::path file = folder / claim.first;
        write_all(file, claim.second);
        CHECK(!user_error_of([&] { load_lat_long(file); }).empty());
    }
    CHECK(resident_max() - before < 300 * 1024);
}

TEST_CASE("damaged picture: blocks of an EXR that hold fewer pixels than they stand for show no memory") {
    const TemporaryFolder folder;
    for (const char* compression : {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "dwaa", "dwab"}) {
        CAPTURE(compression);
        const fs::path file = folder / (std::string(compression) + ".exr");
        write_picture(file, quarters(), {.texts = {{"compression", compression}}});
        REQUIRE(load_colours(file).width == 64);
        // 9 * 256 more columns of data, outside of what is shown.
        std::string bytes = read_all(file);
        bytes[bytes.find("dataWindow") + 11 + 6 + 4 + 9] = 9;
        write_all(file, bytes);
        const std::string first = outcome(file, 85);
        write_all(file, bytes + " ");  // so that what is kept does not stand in for it
        const std::string second = outcome(file, 170);
        // PIZ repeats what it has, so that it depends on the file alone.
        CHECK((is_error(first) || (std::string(compression) == "piz" && first == second)));
    }
}

TEST_CASE("damaged picture: any number of an EXR's attributes changes nothing") {
    const TemporaryFolder folder;
    write_all(folder / "few.exr", exr_file(quarters(), 0));
    write_all(folder / "many.exr", exr_file(quarters(), 300000));
    CHECK(load_colours(folder / "few.exr").colours == load_colours(folder / "many.exr").colours);
}

TEST_SUITE_END();
