#include "core/image/picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/image/clear_part.h"
#include "core/image/luminance.h"
#include "core/pictures/decoder.h"
#include "core/pictures/environment_picture.h"
#include "core/pictures/light_of.h"
#include "core/pictures/made_square.h"
#include "core/pictures/orientation.h"
#include "core/pictures/picture_problem.h"
#include "core/pictures/stamp_picture.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr PictureLimits picture_limits{limits::picture_max, limits::picture_max, limits::file_bytes_max};

std::size_t pixel_count(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

Raster read_grey(Decoder& picture) {
    const PictureHeader& header = picture.header();
    const LightOf light_of(header);
    const glm::ivec2 size = upright_size(header.size, header.orientation);
    constexpr double most = std::numeric_limits<float>::max();
    std::vector<float> values;
    values.reserve(pixel_count(size));
    picture.read_rows([&](int y, PixelRow row) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            for (int c = 0; c < 4; ++c)
                if (row[x][c] < 0) {
                    const glm::ivec2 at = upright_place({x, y}, header.size, header.orientation);
                    throw PictureProblem(
                        fmt::format("pixel ({}, {}) from the top left is {}, must be finite and >= 0", at.x,
                                    at.y, row[x][c]));
                }
            const glm::dvec3 light = light_of(row[x]);
            const double grey = header.channels == 1 ? light.x : luminance(light);
            values.push_back(static_cast<float>(std::clamp(grey, 0.0, most)));
        }
    });
    return {size.x, size.y, upright(std::move(values), header.size, header.orientation)};
}

Raster read_picture(const fs::path& file, PictureShape shape, PictureNotes& notes) {
    const auto picture = open_picture(file, picture_limits, PictureUse::light);
    const glm::ivec2 size = upright_size(picture->header().size, picture->header().orientation);
    if (shape == PictureShape::square && size.x != size.y)
        throw PictureProblem(fmt::format("{} x {} pixels, a picture must be square", size.x, size.y));
    notes = picture->header().notes;
    return made_square(read_grey(*picture), notes);
}

ColourPicture read_colours(const fs::path& file, PictureNotes& notes) {
    const auto picture = open_picture(file, picture_limits, PictureUse::data);
    const PictureHeader& header = picture->header();
    const glm::ivec2 size = upright_size(header.size, header.orientation);
    std::vector<glm::vec3> colours;
    colours.reserve(pixel_count(size));
    std::vector<float> alpha;
    picture->read_rows([&](int, PixelRow row) {
        colours.insert(colours.end(), row.begin(), row.end());
        if (header.has_alpha)
            for (const glm::vec4& pixel : row) alpha.push_back(pixel.a);
    });
    notes = header.notes;
    if (header.has_alpha) alpha = upright(std::move(alpha), header.size, header.orientation);
    return {size.x,          size.y,         upright(std::move(colours), header.size, header.orientation),
            header.channels, header.encoded, std::move(alpha)};
}

double read_clear_part(const fs::path& file) {
    constexpr float clear = 0.1f;
    const auto picture = open_picture(file, picture_limits, PictureUse::light);
    if (!picture->header().has_alpha) return 0;
    std::size_t count = 0;
    picture->read_rows([&](int, PixelRow row) {
        for (const glm::vec4& pixel : row) count += pixel.a < clear ? 1 : 0;
    });
    return static_cast<double>(count) / static_cast<double>(pixel_count(picture->header().size));
}

// What `load` makes, or nothing and the reason.
template <class Load>
auto or_reason(const Load& load, PictureNotes* notes, std::string& reason) {
    PictureNotes found;
    std::optional<decltype(load(found))> result;
    try {
        result = load(found);
        if (notes != nullptr) *notes = std::move(found);
    } catch (const std::exception& problem) {
        reason = one_line(problem.what(), 600);
    } catch (...) {
        reason = "its reader gave up";
    }
    return result;
}

}  // namespace

Raster load_picture(const fs::path& file, const std::string& error_file, const std::string& error_where,
                    PictureShape shape, PictureNotes* notes) {
    std::string reason;
    if (auto raster =
            or_reason([&](PictureNotes& found) { return read_picture(file, shape, found); }, notes, reason))
        return *std::move(raster);
    throw UserError(error_file, error_where, "the picture " + file.string() + " cannot be used", reason);
}

Raster load_stamp(const fs::path& file, PictureNotes* notes) {
    std::string reason;
    if (auto raster = or_reason([&](PictureNotes& found) { return read_stamp(file, found); }, notes, reason))
        return *std::move(raster);
    throw UserError(file.string(), "read", "the picture cannot be used as a stamp", reason);
}

ColourPicture load_colours(const fs::path& file, PictureNotes* notes) {
    std::string reason;
    if (auto picture =
            or_reason([&](PictureNotes& found) { return read_colours(file, found); }, notes, reason))
        return *std::move(picture);
    throw UserError(file.string(), "read", "the picture cannot be used", reason);
}

double load_clear_part(const fs::path& file) {
    std::string reason;
    if (auto part = or_reason([&](PictureNotes&) { return read_clear_part(file); }, nullptr, reason))
        return *part;
    throw UserError(file.string(), "read", "the picture cannot be used", reason);
}

LatLong load_lat_long(const fs::path& file, PictureNotes* notes) {
    std::string reason;
    if (auto light =
            or_reason([&](PictureNotes& found) { return read_environment(file, found); }, notes, reason))
        return *std::move(light);
    throw UserError(file.string(), "read", "the picture cannot be used as an environment", reason);
}

}  // namespace nacre
