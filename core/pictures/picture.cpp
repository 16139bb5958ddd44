#include "core/exchange/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "core/design/error.h"
#include "core/exchange/area_average.h"
#include "core/exchange/input_file.h"
#include "core/exchange/letterbox.h"
#include "core/exchange/png_chunks.h"
#include "core/model/luminance.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int channels_max = 8;
constexpr int lat_long_max = 8192;   // pixels a side of a file ...
constexpr int lat_long_kept = 2048;  // ... and of what is kept of it

// A picture that cannot be used, with the reason.
struct PictureProblem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// OpenImageIO's name of the format, by the file's first bytes: its own choice by file name would also
// try movies, raw camera files and formats without content.
std::string format_of(const fs::path& file) {
    using namespace std::string_view_literals;
    constexpr std::pair<std::string_view, const char*> signatures[] = {{"\x89PNG\r\n"sv, "png"},
                                                                       {"\xFF\xD8\xFF"sv, "jpeg"},
                                                                       {"\x76\x2F\x31\x01"sv, "openexr"},
                                                                       {"II*\0"sv, "tiff"},
                                                                       {"MM\0*"sv, "tiff"},
                                                                       {"II+\0"sv, "tiff"},
                                                                       {"MM\0+"sv, "tiff"},
                                                                       {"#?"sv, "hdr"},
                                                                       {"P2"sv, "pnm"},
                                                                       {"P3"sv, "pnm"},
                                                                       {"P5"sv, "pnm"},
                                                                       {"P6"sv, "pnm"},
                                                                       {"PF"sv, "pnm"},
                                                                       {"Pf"sv, "pnm"}};
    std::array<char, 8> start{};
    std::ifstream(file, std::ios::binary).read(start.data(), start.size());
    for (const auto& [signature, name] : signatures)
        if (std::string_view(start.data(), start.size()).starts_with(signature)) return name;
    throw PictureProblem("no PNG, EXR, TIFF, JPEG, HDR or PNM picture");
}

// The reason that the reader gives; asking also keeps it from being printed when the reader goes.
std::string reason_of(OIIO::ImageInput& input) {
    const std::string reason = input.geterror();
    return reason.empty() ? "the picture is damaged" : reason;
}

void check_header(const OIIO::ImageSpec& spec, PictureShape shape) {
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep)
        throw PictureProblem("no flat picture");
    if (shape == PictureShape::square && spec.width != spec.height)
        throw PictureProblem(
            fmt::format("{} x {} pixels, a picture must be square", spec.width, spec.height));
    if (shape == PictureShape::lat_long && spec.width != 2 * spec.height)
        throw PictureProblem(
            fmt::format("{} x {} pixels, must be twice as wide as high", spec.width, spec.height));
    const int most = shape == PictureShape::lat_long ? lat_long_max : limits::picture_max;
    if (std::max(spec.width, spec.height) > most)
        throw PictureProblem(
            fmt::format("{} x {} pixels, more than {} a side", spec.width, spec.height, most));
    if (spec.nchannels < 1 || spec.nchannels > channels_max)
        throw PictureProblem(fmt::format("{} channels, must be 1 to {}", spec.nchannels, channels_max));
    if (spec.tile_width > limits::picture_max || spec.tile_height > limits::picture_max ||
        spec.tile_depth > 1)
        throw PictureProblem(fmt::format("tiles of {} x {} pixels", spec.tile_width, spec.tile_height));
    const bool cropped = spec.width != spec.full_width || spec.height != spec.full_height;
    if (cropped) throw PictureProblem("cropped: the data window must be the display window");
}

double decode_srgb(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// Turns the channels of one pixel into one grey value.
struct GreyReader {
    int alpha = -1;                      // channel, or none
    std::array<int, 3> colour{0, 0, 0};  // channels
    int colours = 1;
    bool encoded = false;     // as sRGB
    bool associated = false;  // the colours have been multiplied by alpha already

    explicit GreyReader(const OIIO::ImageSpec& spec)
        : alpha(spec.nchannels > 1 ? spec.alpha_channel : -1),
          colours(spec.nchannels - (alpha >= 0 ? 1 : 0) >= 3 ? 3 : 1),
          encoded(!spec.format.is_floating_point()),
          associated(alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0) {
        int channel = 0;
        for (int i = 0; i < colours; ++channel)
            if (channel != alpha) colour[static_cast<std::size_t>(i++)] = channel;
    }

    int channels_needed() const { return 1 + std::max({alpha, colour[0], colour[1], colour[2]}); }

    double operator()(const float* pixel) const {
        if (colours == 1) return linear(pixel, colour[0]);
        return luminance({linear(pixel, colour[0]), linear(pixel, colour[1]), linear(pixel, colour[2])});
    }

    double linear(const float* pixel, int channel) const {
        const double value = pixel[channel];
        const double opacity = alpha < 0 ? 1 : pixel[alpha];
        if (opacity == 0) return 0;
        if (!encoded) return associated ? value : value * opacity;
        return opacity * decode_srgb(associated ? std::min(value / opacity, 1.0) : value);
    }
};

Raster read_pixels(OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    const GreyReader grey(spec);
    const auto width = static_cast<std::size_t>(spec.width), height = static_cast<std::size_t>(spec.height);
    const auto channels = static_cast<std::size_t>(grey.channels_needed());
    std::vector<float> pixels(width * height * channels);
    const bool read = input.read_image(0, 0, 0, grey.channels_needed(), OIIO::TypeDesc::FLOAT, pixels.data());
    if (!read || input.has_error()) throw PictureProblem(reason_of(input));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (!std::isfinite(pixels[i]) || pixels[i] < 0)
            throw PictureProblem(
                fmt::format("pixel ({}, {}) from the top left is {}, must be finite and >= 0",
                            i / channels % width, i / channels / width, pixels[i]));
    Raster raster{spec.width, spec.height, std::vector<float>(width * height)};
    constexpr double most = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < width * height; ++i)
        raster.values[i] = static_cast<float>(std::min(grey(&pixels[i * channels]), most));
    return raster;
}

// Turns a picture that was taken lying or mirrored; `orientation` is EXIF's, 1 to 8.
Raster upright(const Raster& raster, int orientation) {
    if (orientation <= 1 || orientation > 8) return raster;
    const bool transposes = orientation >= 5;
    const bool flips_x = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool flips_y = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Raster turned = raster;
    if (transposes) std::swap(turned.width, turned.height);
    for (int y = 0; y < turned.height; ++y)
        for (int x = 0; x < turned.width; ++x) {
            const int column = transposes ? y : x;
            const int row = transposes ? x : y;
            const int from = (flips_y ? raster.height - 1 - row : row) * raster.width +
                             (flips_x ? raster.width - 1 - column : column);
            turned.values[static_cast<std::size_t>(y * turned.width + x)] =
                raster.values[static_cast<std::size_t>(from)];
        }
    return turned;
}

// Opens the picture and returns what `read` makes of it.
template <class Read>
auto with_picture(const fs::path& file, PictureShape shape, const Read& read) {
    if (const std::string problem = input_file_problem(file); !problem.empty()) throw PictureProblem(problem);
    const std::string format = format_of(file);
    std::string png = format == "png" ? essential_png(read_text_file(file)) : "";
    OIIO::Filesystem::IOMemReader memory(png.data(), png.size());
    const auto input = OIIO::ImageInput::create(format);
    if (!input) throw PictureProblem(OIIO::geterror());
    if (!png.empty()) input->set_ioproxy(&memory);
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec spec;
    if (!input->open(file.string(), spec, as_stored)) throw PictureProblem(reason_of(*input));
    check_header(spec, shape);
    return read(*input, spec);
}

Raster read_picture(const fs::path& file, PictureShape shape) {
    return with_picture(file, shape, [](OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
        const Raster raster =
            letterboxed(upright(read_pixels(input), spec.get_int_attribute("Orientation", 1)));
        return raster.width > limits::raster_max ? area_average(raster, limits::raster_max) : raster;
    });
}

ColourPicture read_colours(OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    const int alpha = spec.nchannels > 1 && spec.alpha_channel == spec.nchannels - 1 ? 1 : 0;
    const int channels = std::min(spec.nchannels - alpha, 3);
    const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<float> pixels(count * static_cast<std::size_t>(channels));
    const bool read = input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, pixels.data());
    if (!read || input.has_error()) throw PictureProblem(reason_of(input));
    if (!std::all_of(pixels.begin(), pixels.end(), [](float value) { return std::isfinite(value); }))
        throw PictureProblem("a pixel is not finite");
    ColourPicture picture{spec.width, spec.height, {}, channels, !spec.format.is_floating_point()};
    for (std::size_t i = 0; i < count; ++i) {
        const float* pixel = &pixels[i * static_cast<std::size_t>(channels)];
        picture.colours.push_back(channels == 1
                                      ? glm::vec3(pixel[0])
                                      : glm::vec3(pixel[0], pixel[1], channels == 3 ? pixel[2] : 0));
    }
    return picture;
}

// The mean over each of fewer texels; whole texels of the picture go into each.
LatLong averaged_down(const ColourPicture& picture, int width) {
    LatLong light{width, width / 2, {}};
    light.radiance.reserve(static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height));
    const auto first = [](int i, int of, int among) {
        return static_cast<int>(std::int64_t{i} * among / of);
    };
    for (int row = 0; row < light.height; ++row)
        for (int column = 0; column < light.width; ++column) {
            glm::dvec3 sum{0};
            int count = 0;
            for (int y = first(row, light.height, picture.height);
                 y < first(row + 1, light.height, picture.height); ++y)
                for (int x = first(column, width, picture.width); x < first(column + 1, width, picture.width);
                     ++x) {
                    sum += glm::dvec3(picture.colours[static_cast<std::size_t>(y) *
                                                          static_cast<std::size_t>(picture.width) +
                                                      static_cast<std::size_t>(x)]);
                    ++count;
                }
            light.radiance.emplace_back(sum / static_cast<double>(count));
        }
    return light;
}

LatLong read_lat_long(OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    ColourPicture picture = read_colours(input, spec);
    const bool encoded = !spec.format.is_floating_point();
    for (std::size_t i = 0; i < picture.colours.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            float& value = picture.colours[i][c];
            if (value < 0)
                throw PictureProblem(fmt::format("pixel ({}, {}) from the top left is {}, must be >= 0",
                                                 i % static_cast<std::size_t>(spec.width),
                                                 i / static_cast<std::size_t>(spec.width), value));
            if (encoded) value = static_cast<float>(decode_srgb(static_cast<double>(value)));
        }
    return averaged_down(picture, std::min(spec.width, lat_long_kept));
}

template <class Load>
auto or_reason(const Load& load, std::string& reason) -> std::optional<decltype(load())> {
    try {
        return load();
    } catch (const std::exception& problem) {
        reason = problem.what();
    } catch (...) {
        reason = "its reader gave up";
    }
    return {};
}

}  // namespace

Raster load_picture(const fs::path& file, const std::string& error_file, const std::string& error_where,
                    PictureShape shape) {
    std::string reason;
    if (auto raster = or_reason([&] { return read_picture(file, shape); }, reason)) return *std::move(raster);
    throw UserError(error_file, error_where, "the picture " + file.string() + " cannot be used", reason);
}

ColourPicture load_colours(const fs::path& file) {
    std::string reason;
    if (auto picture = or_reason([&] { return with_picture(file, PictureShape::any, read_colours); }, reason))
        return *std::move(picture);
    throw UserError(file.string(), "read", "the picture cannot be used", reason);
}

LatLong load_lat_long(const fs::path& file) {
    std::string reason;
    if (auto light =
            or_reason([&] { return with_picture(file, PictureShape::lat_long, read_lat_long); }, reason))
        return *std::move(light);
    throw UserError(file.string(), "read", "the picture cannot be used as an environment", reason);
}

}  // namespace nacre
