// A picture of one format (NACRE_FUZZ_FORMAT) through the loader, for every use.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>

#include "core/image/picture.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"
#include "tests/fuzz/target.h"

using namespace nacre;

namespace {

std::string input_path(const std::uint8_t* data, std::size_t size) {
    static const int input = memfd_create("picture", 0);
    fuzz::require(ftruncate(input, 0) == 0 && pwrite(input, data, size, 0) == static_cast<ssize_t>(size),
                  "the input is written");
    return "/proc/self/fd/" + std::to_string(input);
}

// Whether the input is taken for another format, which has a target of its own.
bool is_other_format(const std::string& file) {
    try {
        return examine(FileBytes(file, UINTMAX_MAX)).format != NACRE_FUZZ_FORMAT;
    } catch (const PictureProblem&) {
        return false;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string file = input_path(data, size);
    if (is_other_format(file)) return -1;
    fuzz::reads([&] {
        for (const float value : load_picture(file, "fuzz.nacre", "image", PictureShape::any).values)
            fuzz::require(std::isfinite(value) && value >= 0, "a stamp is finite and not negative");
    });
    fuzz::reads([&] {
        for (const glm::vec3& colour : load_colours(file).colours)
            for (int c = 0; c < 3; ++c) fuzz::require(std::isfinite(colour[c]), "a colour is finite");
    });
    fuzz::reads([&] {
        for (const glm::vec3& radiance : load_lat_long(file).radiance)
            for (int c = 0; c < 3; ++c)
                fuzz::require(std::isfinite(radiance[c]) && radiance[c] >= 0,
                              "light is finite, not negative");
    });
    return 0;
}
