#include "core/pictures/stamp_picture.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/limits.h"
#include "core/image/luminance.h"
#include "core/pictures/decoder.h"
#include "core/pictures/light_of.h"
#include "core/pictures/made_square.h"
#include "core/pictures/orientation.h"

namespace nacre {
namespace {

constexpr double white = 0.9;        // at least, of a white ground; as stored
constexpr double clear = 0.1;        // at most, of a transparent one
constexpr double dark = 0.5;         // at most, in the mean over what stands on it
constexpr double ground_part = 0.8;  // of the picture's edge, at least

// The numbers of a pixel, upright, rows from the top.
struct Pixel {
    float light;  // linear, times alpha
    float shown;  // as stored: where an edge is smooth, the part that is covered
    float alpha;
};

struct Pixels {
    int width, height;
    std::vector<Pixel> values;
};

Pixels read_pixels(Decoder& picture) {
    const PictureHeader& header = picture.header();
    const LightOf light_of(header);
    std::vector<Pixel> values;
    values.reserve(static_cast<std::size_t>(header.size.x) * static_cast<std::size_t>(header.size.y));
    picture.read_rows([&](int, PixelRow row) {
        for (const glm::vec4& pixel : row) {
            const double alpha = header.has_alpha ? std::clamp(static_cast<double>(pixel.w), 0.0, 1.0) : 1;
            double shown = luminance(glm::max(glm::dvec3(pixel), 0.0));
            if (header.associated && alpha > 0) shown /= alpha;
            const double light = std::max(luminance(light_of(pixel)), 0.0);
            values.push_back(
                {static_cast<float>(light), static_cast<float>(shown), static_cast<float>(alpha)});
        }
    });
    const glm::ivec2 size = upright_size(header.size, header.orientation);
    return {size.x, size.y, upright(std::move(values), header.size, header.orientation)};
}

// The part of the pixels along the picture's edge that `is` holds for.
template <class Is>
double part_of_edge(const Pixels& pixels, const Is& is) {
    int count = 0, found = 0;
    for (int row = 0; row < pixels.height; ++row) {
        const bool whole = row == 0 || row == pixels.height - 1;
        for (int column = 0; column < pixels.width; column += whole ? 1 : std::max(pixels.width - 1, 1)) {
            const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels.width) +
                                      static_cast<std::size_t>(column);
            ++count;
            found += is(pixels.values[index]) ? 1 : 0;
        }
    }
    return static_cast<double>(found) / count;
}

bool stands_dark(const Pixels& pixels) {
    double shown = 0, alpha = 0;
    for (const Pixel& pixel : pixels.values) {
        shown += static_cast<double>(pixel.alpha * pixel.shown);
        alpha += static_cast<double>(pixel.alpha);
    }
    return alpha > 0 && shown < dark * alpha;
}

// Why the dark paints; null where the light does.
const char* why_dark(const Pixels& pixels) {
    const auto is_white = [](const Pixel& p) { return p.alpha > 1 - clear && p.shown > white; };
    const auto is_clear = [](const Pixel& p) { return p.alpha < clear; };
    if (part_of_edge(pixels, is_white) >= ground_part) return "the dark paints, since its edge is white";
    if (part_of_edge(pixels, is_clear) >= ground_part && stands_dark(pixels))
        return "the dark paints, since it stands on a transparent ground";
    return nullptr;
}

}  // namespace

Raster read_stamp(const std::filesystem::path& file, PictureNotes& notes) {
    constexpr PictureLimits most{limits::picture_max, limits::picture_max, limits::file_bytes_max};
    const auto picture = open_picture(file, most, PictureUse::light);
    notes = picture->header().notes;
    const Pixels pixels = read_pixels(*picture);
    const char* const why = picture->header().encoded ? why_dark(pixels) : nullptr;
    Raster raster{pixels.width, pixels.height, {}};
    raster.values.reserve(pixels.values.size());
    for (const Pixel& pixel : pixels.values)
        raster.values.push_back(why != nullptr ? pixel.alpha * std::clamp(1 - pixel.shown, 0.0f, 1.0f)
                                               : pixel.light);
    const float largest = *std::max_element(raster.values.begin(), raster.values.end());
    if (largest > 1)
        for (float& value : raster.values) value /= largest;
    Raster square = made_square(raster, notes);
    if (why != nullptr) notes.emplace_back(why);
    return square;
}

}  // namespace nacre
