// nacre-real-normals FILE...: reads each as a normal map by what its numbers speak for; one line a file, and
// an exit code of 1 where one is not what normal maps of games and of the web are: encoded, of three
// channels, facing up nearly everywhere.
#include <fmt/core.h>

#include <cstdio>
#include <span>
#include <stdexcept>
#include <string>

#include "core/paint/normal_map.h"
#include "core/paint/picture_guess.h"

namespace {

using namespace nacre;

std::string read(const std::string& file) {
    ColourPicture picture = load_colours(file);
    const NormalMapLook look = look_at_normal_map(picture);
    if (look.reading != NormalReading{}) throw std::runtime_error("not read as encoded in three channels");
    const NormalCounts counts = count_normals(picture, look.reading);
    if (100 * (counts.empty + counts.not_facing_up) > counts.pixels)
        throw std::runtime_error("more than a hundredth left out: " + note_on(counts));
    const std::vector<dvec3> normals = normals_of_map(picture, look.reading);
    dvec3 mean{0};
    for (const dvec3 n : normals) mean += n / static_cast<double>(normals.size());
    if (!(mean.z > 0.75)) throw std::runtime_error(fmt::format("n.z is {:.2f} in the mean", mean.z));
    raster_of_normals(normals, 1.5);
    if (likely_use(picture_statistics(picture, look.reading)).use != ImportUse::normals)
        throw std::runtime_error("not taken for normals");
    // What is said of green follows green.
    for (glm::vec3& colour : picture.colours) colour.y = 1 - colour.y;
    const std::optional<bool> turned = look_at_normal_map(picture).green_down;
    if (turned.has_value() != look.green_down.has_value() || (turned && *turned == *look.green_down))
        throw std::runtime_error("green turned round says the same");
    const char* const green = !look.green_down ? "either way" : *look.green_down ? "down" : "up";
    return fmt::format("{} x {}, n.z {:.3f}, green {}; {}", picture.width, picture.height, mean.z, green,
                       note_on(counts));
}

}  // namespace

int main(int count, char** arguments) {
    bool good = count > 1;
    for (const std::string file : std::span(arguments, static_cast<std::size_t>(count)).subspan(1)) {
        try {
            fmt::print("{}: {}\n", file, read(file));
        } catch (const std::exception& error) {
            fmt::print(stderr, "{}: {}\n", file, error.what());
            good = false;
        }
    }
    return good ? 0 : 1;
}
