// A designer that has opened a file which others change.
#pragma once

#include "core/design/design_file.h"
#include "core/image/image_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

namespace nacre::test {

inline void write_grey(const std::filesystem::path& file, float value, int side = 8) {
    write_image(file, {side, side}, std::vector<float>(static_cast<std::size_t>(side * side * 3), value));
}

// An environment of one brightness.
inline void write_sky(const std::filesystem::path& file, float value) {
    write_image(file, {16, 8}, std::vector<float>(std::size_t{16} * 8 * 3, value));
}

// A design with the picture paper.exr as its second layer, and the first modulated by spots.exr.
struct Pictured : TemporaryFolder {
    std::filesystem::path file = *this / "mine.nacre";
    Pictured() {
        write_grey(*this / "paper.exr", 0.5f);
        write_grey(*this / "spots.exr", 0.25f);
        write_all(
            file,
            "{\"nacre\": 1, \"name\": \"Mine\", \"distribution\": {\"layers\": [{\"lobe\": \"gaussian\", "
            "\"modulation\": {\"image\": \"spots.exr\"}}, "
            "{\"lobe\": \"painted\", \"image\": \"paper.exr\"}]}}");
    }
};

struct FileRig : Rig {
    explicit FileRig(const std::filesystem::path& file) {
        if (!file.empty()) open_at_start(designer(), file);
        play("frames 2");
    }
    bool asks(const char* button) { return stage.items().rectangle(button).has_value(); }
    // The window gets the focus, and files that changed meanwhile are noticed.
    void focus() { play("focus\nframes 3"); }
};

}  // namespace nacre::test
