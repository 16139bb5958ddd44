// `source` of a layer in the design file.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "core/design/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::string design_with(const std::string& layer) {
    return "{\"nacre\": 2, \"distribution\": {\"layers\": [{" + layer + "}]}}";
}

std::string painted_with(const std::string& source) {
    return design_with(
        "\"lobe\": \"painted\", \"image\": {\"width\": 1, \"height\": 1, \"values\": [1]}, \"source\": " +
        source);
}

Design parse(const std::string& text) { return parse_design(text, "test.nacre", "/designs"); }

std::string refused(const std::string& text) {
    return user_error_of([&] { parse(text); });
}

}  // namespace

TEST_CASE("source file: every key reaches its place, and comes back") {
    const Design design = parse(painted_with(
        R"({"image": "../maps/a.png", "as": "normals", "size": 12, "encoding": "signed", "channels": "xy", "green": "down",
            "height": -3, "smoothing": 0.5, "rotation": 45, "flip": true})"));
    const PictureSource expected{.image = "/maps/a.png",
                                 .as = SourceUse::normals,
                                 .size = 12,
                                 .reading = {true, true, true},
                                 .height = -3,
                                 .smoothing = 0.5,
                                 .rotation = 45,
                                 .flip = true};
    REQUIRE(design.distribution.layers[0].source);
    CHECK(*design.distribution.layers[0].source == expected);
    CHECK(parse(design_json(design, "/designs")) == design);
    // The picture is not needed, and is no picture of the design.
    CHECK(picture_files(design).empty());
    CHECK(source_files(design) == std::vector<std::filesystem::path>{"/maps/a.png"});
}

TEST_CASE("source file: what is at its default is not written, and a source makes version 2") {
    for (const char* as : {"stamp", "normals", "heights"}) {
        const Design design =
            parse(painted_with("{\"image\": \"a.png\", \"as\": \"" + std::string(as) + "\"}"));
        CHECK(version_of(design) == 2);
        const std::string text = design_json(design, "/designs");
        CHECK(text.find("\"source\": {\"image\": \"a.png\", \"as\": \"" + std::string(as) + "\"}") !=
              text.npos);
        CHECK(parse(text) == design);
    }
    Design plain = parse(painted_with("{\"image\": \"a.png\", \"as\": \"stamp\"}"));
    plain.distribution.layers[0].source.reset();
    CHECK(version_of(plain) == 1);
    CHECK(design_json(plain, "/designs").find("source") == std::string::npos);
}

TEST_CASE("source file: what is wrong is named") {
    const auto has = [](const std::string& text, const char* part) { return text.find(part) != text.npos; };
    CHECK(has(refused(painted_with("{\"as\": \"stamp\"}")), "layers[0].source"));
    CHECK(has(refused(painted_with("{\"image\": \"\", \"as\": \"stamp\"}")), "source.image"));
    CHECK(has(refused(painted_with("{\"image\": \"a.png\"}")), "as"));
    CHECK(has(refused(painted_with("{\"image\": \"a.png\", \"as\": \"colours\"}")), "source.as"));
    CHECK(has(refused(painted_with("{\"image\": \"a.png\", \"as\": \"heights\", \"height\": 1001}")),
              "source.height"));
    CHECK(has(refused(painted_with("{\"image\": \"a.png\", \"as\": \"stamp\", \"hue\": 1}")), "hue"));
    // Of a painted lobe alone.
    CHECK(
        has(refused(design_with("\"lobe\": \"ggx\", \"source\": {\"image\": \"a.png\", \"as\": \"stamp\"}")),
            "source"));
}
