// Pictures that are read once and kept, and what is said of them.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "core/design/design_pictures.h"
#include "core/image/image_file.h"
#include "core/image/picture.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

void write_grey(const fs::path& file, glm::ivec2 size, float value) {
    write_image(file, size, std::vector<float>(static_cast<std::size_t>(size.x * size.y * 3), value));
}

PictureNotes notes_of(const fs::path& file) {
    PictureNotes notes;
    load_picture(file, "test.nacre", "here.image", PictureShape::any, &notes);
    return notes;
}

}  // namespace

TEST_CASE("picture: the same content is decoded once, wherever it stands and whoever asks") {
    const TemporaryFolder folder;
    write_grey(folder / "a.exr", {8, 8}, 0.5f);
    const auto shared = [&](const char* name) {
        PictureNotes notes;
        return load_shared_picture(folder / name, "test.nacre", "here.image", notes);
    };
    const auto first = shared("a.exr");
    fs::copy_file(folder / "a.exr", folder / "b.exr");
    CHECK(shared("b.exr") == first);
    CHECK(load_picture(folder / "a.exr", "test.nacre", "here.image") == *first);
    // Other content of the same size at once, under the same name.
    const auto size = fs::file_size(folder / "a.exr");
    write_grey(folder / "a.exr", {8, 8}, 0.25f);
    REQUIRE(fs::file_size(folder / "a.exr") == size);
    CHECK(shared("a.exr") != first);
}

TEST_CASE("picture: what was changed of its size is said") {
    const TemporaryFolder folder;
    write_grey(folder / "square.exr", {8, 8}, 0.5f);
    write_grey(folder / "wide.exr", {8, 2}, 0.5f);
    write_grey(folder / "large.exr", {1500, 1500}, 0.5f);
    write_grey(folder / "tall.exr", {3, 1500}, 0.5f);
    CHECK(notes_of(folder / "square.exr").empty());
    CHECK(notes_of(folder / "wide.exr") == PictureNotes{"8 x 2 pixels, made square with black beside it"});
    CHECK(notes_of(folder / "large.exr") == PictureNotes{"1500 x 1500 pixels, averaged down to 1024 x 1024"});
    CHECK(notes_of(folder / "tall.exr") ==
          PictureNotes{"3 x 1500 pixels, made square with black beside it, averaged down to 1024 x 1024"});
}

TEST_CASE("picture: a design has the notes of its files, also when they are read again, and is the same") {
    const TemporaryFolder folder;
    const fs::path large = folder / "large.exr";
    write_grey(large, {1200, 1200}, 0.5f);
    write_all(
        folder / "a.nacre",
        "{\"nacre\": 1, \"distribution\": {\"layers\": [{\"lobe\": \"painted\", \"image\": \"large.exr\"}, "
        "{\"lobe\": \"gaussian\", \"modulation\": {\"image\": \"large.exr\"}}]}}");
    const Design design = load_design(folder / "a.nacre");
    const auto all_notes = [](const Design& of) {
        std::vector<PictureNotes> all;
        for_each_picture(of, [&](const Picture& picture, const auto&) { all.push_back(picture.notes); });
        return all;
    };
    const PictureNotes said = {"1200 x 1200 pixels, averaged down to 1024 x 1024"};
    CHECK(all_notes(design) == std::vector{said, said});
    const Design held = with_pictures_held(design, {large});
    CHECK(all_notes(held) == std::vector{said, said});
    Design silent = design;
    for_each_picture(silent, [](Picture& picture, const auto&) { picture.notes.clear(); });
    CHECK(silent == design);
    write_grey(large, {8, 8}, 0.5f);
    CHECK(all_notes(with_pictures_reread(design, {large}, "a.nacre")) ==
          std::vector{PictureNotes{}, PictureNotes{}});
}
