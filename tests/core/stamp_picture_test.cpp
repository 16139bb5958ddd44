// What of a picture paints when it is a stamp.
#include <doctest/doctest.h>

#include <string>

#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

// A disc of radius 8 in the middle of 20 x 20, on whatever stands behind it.
std::string disc_svg(const std::string& fill, const std::string& behind = "") {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 20'>" + behind +
           "<circle cx='10' cy='10' r='8' fill='" + fill + "'/></svg>";
}

struct Stamp {
    Raster raster;
    PictureNotes notes;

    // At a point in [0, 1] from the left top corner.
    double at(double x, double y) const {
        const auto texel = [&](double t) { return static_cast<std::size_t>(t * raster.width); };
        return static_cast<double>(
            raster.values[texel(y) * static_cast<std::size_t>(raster.width) + texel(x)]);
    }
};

Stamp stamp_of(const fs::path& file) {
    Stamp stamp;
    stamp.raster = load_stamp(file, &stamp.notes);
    return stamp;
}

}  // namespace

TEST_CASE("stamp picture: a drawing paints where it is dark on nothing or on white, else where it is light") {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "a.svg";
    const std::string white = "<rect width='20' height='20' fill='#fff'/>",
                      black = "<rect width='20' height='20'/>";
    test::write_all(file, disc_svg("#000"));
    Stamp stamp = stamp_of(file);
    CHECK(stamp.raster.width == 1024);
    CHECK(stamp.at(0.5, 0.5) == 1);
    CHECK(stamp.at(0.05, 0.05) == 0);
    CHECK(stamp.notes == PictureNotes{"the dark paints, since it stands on a transparent ground"});
    test::write_all(file, disc_svg("#000", white));
    stamp = stamp_of(file);
    CHECK(stamp.at(0.5, 0.5) == 1);
    CHECK(stamp.at(0.05, 0.05) == 0);
    CHECK(stamp.notes == PictureNotes{"the dark paints, since its edge is white"});
    for (const std::string& behind : {std::string(), black}) {
        test::write_all(file, disc_svg("#fff", behind));
        stamp = stamp_of(file);
        CHECK(stamp.at(0.5, 0.5) == doctest::Approx(1));
        CHECK(stamp.at(0.05, 0.05) == 0);
        CHECK(stamp.notes.empty());
    }
    // Half the light, where it is light that paints.
    test::write_all(file, disc_svg("#bcbcbc"));
    CHECK(stamp_of(file).at(0.5, 0.5) == doctest::Approx(0.503).epsilon(0.01));
}

TEST_CASE("stamp picture: one that is not square keeps its shape") {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "a.svg";
    test::write_all(file,
                    "<svg xmlns='http://www.w3.org/2000/svg' width='4cm' height='1cm'><rect width='100%' "
                    "height='100%' fill='#fff'/><rect x='25%' y='25%' width='50%' height='50%'/></svg>");
    const Stamp stamp = stamp_of(file);
    CHECK(stamp.raster.width == 1024);
    CHECK(stamp.at(0.5, 0.5) == 1);
    CHECK(stamp.at(0.5, 0.3) == 0);
    CHECK(stamp.at(0.1, 0.5) == 0);
    CHECK(stamp.notes.size() == 2);
}

TEST_CASE("stamp picture: a WebP and a PNG that are transparent paint by what stands on nothing") {
    const test::TemporaryFolder folder;
    test::FloatImage image{{8, 8}, 4, {}};
    for (int i = 0; i < 64; ++i) {
        const bool inside = i % 8 > 1 && i % 8 < 6 && i / 8 > 1 && i / 8 < 6;
        image.values.insert(image.values.end(), {0, 0, 0, inside ? 1.0f : 0.0f});
    }
    for (const char* name : {"a.png", "a.webp"}) {
        CAPTURE(name);
        test::write_picture(folder.path() / name, image);
        const Stamp stamp = stamp_of(folder.path() / name);
        CHECK(stamp.at(0.5, 0.5) == 1);
        CHECK(stamp.at(0.1, 0.1) == 0);
    }
}

TEST_CASE("stamp picture: SVG is known by its content, and one that is broken, empty or refers out is told") {
    const test::TemporaryFolder folder;
    const auto problem = [&](const std::string& text) {
        test::write_all(folder.path() / "a.png", text);
        return test::user_error_of([&] { load_stamp(folder.path() / "a.png"); });
    };
    CHECK(problem("<svg xmlns='http://www.w3.org/2000/svg'><path").find("the SVG file is damaged") !=
          std::string::npos);
    CHECK(problem("<svg xmlns='http://www.w3.org/2000/svg'/>").find("draws nothing") != std::string::npos);
    CHECK(problem("<html><svg/></html>").find("SVG picture") != std::string::npos);
    // A picture beside it is not loaded.
    test::write_picture(folder.path() / "white.png", {{2, 2}, 3, std::vector<float>(12, 1)});
    test::write_all(
        folder.path() / "b.svg",
        "<?xml version='1.0'?><!-- > --><!DOCTYPE svg [<!ENTITY c '#000'>]>\n<svg "
        "xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 2 1'>"
        "<image width='1' height='1' xlink:href='white.png'/><rect x='1' width='1' height='1' "
        "fill='#fff'/></svg>");
    const Stamp stamp = stamp_of(folder.path() / "b.svg");
    CHECK(stamp.at(0.25, 0.5) == 0);
    CHECK(stamp.at(0.75, 0.5) == 1);
}
