#include "core/pictures/environment_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "core/pictures/decoder.h"
#include "core/pictures/fitted_average.h"
#include "core/pictures/light_of.h"
#include "core/pictures/orientation.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr int kept_max = 2048;  // pixels across
// The longest side for the width, and the bytes of as many pixels of four floats.
constexpr PictureLimits environment_limits{16384, 8192, std::uintmax_t{16384} * 8192 * 16 + (1u << 24)};

// Of the sphere's twice as wide as high. A picture that is nearly so was cut or rounded; what is far from it,
// as a cube's faces or a mirror ball, has another form.
glm::ivec2 size_to_keep(glm::ivec2 size) {
    constexpr double least = 1.5, most = 4;
    const double ratio = static_cast<double>(size.x) / size.y;
    if (ratio < least || ratio > most)
        throw PictureProblem(fmt::format("{} x {} pixels, must be twice as wide as high", size.x, size.y));
    const int width = std::min({std::max((size.x + 1) / 2, size.y) * 2, kept_max});
    return {width, width / 2};
}

// A million times the sun's: what is brighter is a mistake, and its products would leave the range of floats.
constexpr double radiance_max = 1e15;

// Light below 0, which filters and lossy compression leave beside what is bright, and light past all measure.
struct Bounds {
    std::int64_t below = 0, above = 0;  // pixels
    double least = 0, most = 0;

    void keep(glm::dvec3& light) {
        const double low = std::min({light.x, light.y, light.z}),
                     high = std::max({light.x, light.y, light.z});
        below += low < 0 ? 1 : 0;
        above += high > radiance_max ? 1 : 0;
        least = std::min(least, low);
        most = std::max(most, high);
        light = glm::clamp(light, 0.0, radiance_max);
    }
    void tell(std::int64_t pixels, PictureNotes& notes) const {
        if (below > 0)
            notes.push_back(fmt::format("{} of {} pixels are below 0, down to {:.4g}, and count as 0", below,
                                        pixels, least));
        if (above > 0)
            notes.push_back(fmt::format("{} of {} pixels are above {:g}, up to {:.4g}, and count as that",
                                        above, pixels, radiance_max, most));
    }
};

}  // namespace

LatLong read_environment(const std::filesystem::path& file, PictureNotes& notes) {
    const auto picture = open_picture(file, environment_limits, PictureUse::light);
    const PictureHeader& header = picture->header();
    const LightOf light_of(header);
    const glm::ivec2 size = upright_size(header.size, header.orientation);
    const glm::ivec2 kept = size_to_keep(size);
    const glm::ivec2 kept_stored = upright_size(kept, header.orientation);
    FittedAverage average(header.size, kept_stored);
    Bounds bounds;
    std::vector<glm::dvec3> lights(static_cast<std::size_t>(header.size.x));
    picture->read_rows([&](int y, PixelRow row) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            lights[x] = light_of(row[x]);
            bounds.keep(lights[x]);
        }
        average.add(y, lights);
    });
    notes = header.notes;
    bounds.tell(std::int64_t{size.x} * size.y, notes);
    if (size.x != 2 * size.y)
        notes.push_back(fmt::format("{} x {} pixels, fitted to {} x {}, twice as wide as high", size.x,
                                    size.y, kept.x, kept.y));
    else if (kept != size)
        notes.push_back(
            fmt::format("{} x {} pixels, averaged down to {} x {}", size.x, size.y, kept.x, kept.y));
    return {kept.x, kept.y, upright(average.result(), kept_stored, header.orientation)};
}

}  // namespace nacre
