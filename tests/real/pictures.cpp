// nacre-real-pictures environments|normals FILE...: reads each as what it is said to be; one line a file, and
// an exit code of 1 where one cannot be used.
#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <span>
#include <string_view>

#include "core/formats/environment_file.h"
#include "core/image/picture.h"
#include "core/paint/normal_map.h"
#include "core/paint/picture_guess.h"

namespace {

using namespace nacre;

bool is_light(glm::vec3 c) {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

std::string read_environment(const std::string& file) {
    const auto environment = load_environment(file);
    const LatLong& picture = environment->picture;
    for (const glm::vec3 c : picture.radiance)
        if (!is_light(c)) throw std::runtime_error("radiance that is none");
    if (picture.width != 2 * picture.height || !(environment->brightness > 0))
        throw std::runtime_error("no light from all around");
    const ColourPicture numbers = load_colours(file);
    if (likely_use(picture_statistics(numbers, look_at_normal_map(numbers).reading)).use !=
        ImportUse::environment)
        throw std::runtime_error("not taken for an environment");
    std::string line = fmt::format("{} x {}", picture.width, picture.height);
    for (const std::string& note : environment->notes) line += "; " + note;
    return line;
}

// Facets of a normal map face up on the whole.
std::string read_normals(const std::string& file) {
    const ColourPicture picture = load_colours(file);
    double up = 0;
    for (const glm::vec3 c : picture.colours) up += static_cast<double>(c.z);
    up /= static_cast<double>(picture.colours.size());
    if (!picture.encoded || picture.channels != 3 || !(up > 0.5))
        throw std::runtime_error(fmt::format("no normal map: blue is {:.2f} on average", up));
    return fmt::format("{} x {}", picture.width, picture.height);
}

}  // namespace

int main(int count, char** arguments) {
    const std::span<char*> all(arguments, static_cast<std::size_t>(count));
    bool good = count > 2;
    for (const std::string file : all.subspan(std::min<std::size_t>(all.size(), 2))) {
        try {
            const bool is_environment = std::string_view(all[1]) == "environments";
            fmt::print("{}: {}\n", file, is_environment ? read_environment(file) : read_normals(file));
        } catch (const std::exception& error) {
            fmt::print(stderr, "{}: {}\n", file, error.what());
            good = false;
        }
    }
    return good ? 0 : 1;
}
