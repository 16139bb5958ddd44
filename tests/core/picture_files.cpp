#include "tests/core/picture_files.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <utility>

#include "core/base/file_extension.h"

namespace nacre::test {
namespace {

std::string number(std::uint64_t value, int length, bool big = false) {
    std::string bytes;
    for (int i = 0; i < length; ++i) {
        const int shift = 8 * (big ? length - 1 - i : i);
        bytes += shift < 64 ? static_cast<char>(value >> shift) : '\0';
    }
    return bytes;
}

const float* pixel(const FloatImage& image, int x, int y) {
    return &image.values[static_cast<std::size_t>((y * image.size.x + x) * image.channels)];
}

char byte(float value) { return static_cast<char>(std::lround(255 * value)); }

std::string bgr(const float* rgb) { return {byte(rgb[2]), byte(rgb[1]), byte(rgb[0])}; }

std::uint64_t png_checksum(const std::string& bytes) {
    return crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
}

const char* format_of(const std::string& extension) {
    if (extension == ".jp2") return "jpeg2000";
    if (extension == ".heic") return "heif";
    if (extension == ".tga") return "targa";
    return nullptr;
}

}  // namespace

FloatImage quarters(glm::ivec2 size) {
    FloatImage image{size, 3, {}};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const bool right = 2 * x >= size.x, low = 2 * y >= size.y;
            image.values.push_back(right != low ? 0.0f : 1.0f);
            image.values.push_back(right ? 1.0f : 0.0f);
            image.values.push_back(low ? 1.0f : 0.0f);
        }
    return image;
}

FloatImage noise(glm::ivec2 size, int channels) {
    FloatImage image{size, channels, {}};
    std::mt19937 random(7);
    for (int i = 0; i < size.x * size.y * channels; ++i)
        image.values.push_back(static_cast<float>(random() >> 8) / static_cast<float>(1 << 24));
    return image;
}

FloatImage stored(const FloatImage& upright, int orientation) {
    // Where the first row and the first column of the file are seen.
    static constexpr const char* sides[8][2] = {{"top", "left"},     {"top", "right"},  {"bottom", "right"},
                                                {"bottom", "left"},  {"left", "top"},   {"right", "top"},
                                                {"right", "bottom"}, {"left", "bottom"}};
    const std::string row = sides[orientation - 1][0], column = sides[orientation - 1][1];
    const bool lies = row == "left" || row == "right";
    FloatImage image{lies ? glm::ivec2(upright.size.y, upright.size.x) : upright.size, upright.channels, {}};
    for (int y = 0; y < image.size.y; ++y)
        for (int x = 0; x < image.size.x; ++x) {
            const int down = lies ? x : y, across = lies ? y : x;
            const std::string vertical = lies ? column : row, horizontal = lies ? row : column;
            const float* const from =
                pixel(upright, horizontal == "left" ? across : upright.size.x - 1 - across,
                      vertical == "top" ? down : upright.size.y - 1 - down);
            image.values.insert(image.values.end(), from, from + image.channels);
        }
    return image;
}

void write_picture(const std::filesystem::path& file, const FloatImage& image,
                   const ImageAttributes& attributes) {
    const std::string extension = extension_of(file);
    const char* const format = format_of(extension);
    const auto output = OIIO::ImageOutput::create(format != nullptr ? format : file.string());
    REQUIRE(output);
    const bool is_float = extension == ".exr" || extension == ".hdr" || extension == ".pfm";
    OIIO::ImageSpec spec(image.size.x, image.size.y, image.channels,
                         is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    if (!attributes.channels.empty()) spec.channelnames = attributes.channels;
    for (const auto& [name, value] : attributes.numbers) spec.attribute(name, value);
    for (const auto& [name, value] : attributes.texts) spec.attribute(name, value);
    if (attributes.display.x > 0) {
        spec.x = attributes.window_at.x;
        spec.y = attributes.window_at.y;
        spec.full_width = attributes.display.x;
        spec.full_height = attributes.display.y;
    }
    REQUIRE(output->open(file.string(), spec));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, image.values.data()));
    REQUIRE(output->close());
}

// X grows to the right, Y upward: "-Y 4 +X 8" are lines from the largest Y to the smallest, each from the
// smallest X to the largest. (Radiance file formats, "Picture File Format")
std::string hdr_file(const FloatImage& upright, const std::string& first, const std::string& second) {
    const auto length = [&](const std::string& axis) {
        return axis[1] == 'X' ? upright.size.x : upright.size.y;
    };
    const auto after = [&](int steps, const std::string& axis) {
        return axis[0] == '+' ? steps : length(axis) - 1 - steps;
    };
    std::string bytes = "#?RADIANCE\nSOFTWARE=test\nFORMAT=32-bit_rle_rgbe\n\n" + first + " " +
                        std::to_string(length(first)) + " " + second + " " + std::to_string(length(second)) +
                        "\n";
    for (int line = 0; line < length(first); ++line)
        for (int i = 0; i < length(second); ++i) {
            int x = after(line, first), up = after(i, second);
            if (first[1] == 'Y') std::swap(x, up);
            const float* const rgb = pixel(upright, x, upright.size.y - 1 - up);
            // The exponent of 1 with a mantissa of 128.
            for (int c = 0; c < 3; ++c) bytes += static_cast<char>(std::lround(128 * rgb[c]));
            bytes += static_cast<char>(129);
        }
    return bytes;
}

std::string targa_file(const FloatImage& upright, bool from_right, bool from_top, bool run_lengths) {
    const auto [w, h] = std::pair(upright.size.x, upright.size.y);
    std::string bytes = std::string(2, '\0') + static_cast<char>(run_lengths ? 10 : 2) +
                        std::string(9, '\0') + number(static_cast<std::uint64_t>(w), 2) +
                        number(static_cast<std::uint64_t>(h), 2) + static_cast<char>(24) +
                        static_cast<char>((from_right ? 0x10 : 0) | (from_top ? 0x20 : 0));
    for (int row = 0; row < h; ++row)
        for (int column = 0; column < w; ++column) {
            if (run_lengths) bytes += '\0';
            bytes += bgr(pixel(upright, from_right ? w - 1 - column : column, from_top ? row : h - 1 - row));
        }
    return bytes;
}

std::string bmp_file(const FloatImage& upright, bool from_top) {
    const auto [w, h] = std::pair(upright.size.x, upright.size.y);
    std::string data;
    for (int row = 0; row < h; ++row) {
        for (int x = 0; x < w; ++x) data += bgr(pixel(upright, x, from_top ? row : h - 1 - row));
        data.resize((data.size() + 3) / 4 * 4);
    }
    return "BM" + number(54 + data.size(), 4) + number(0, 4) + number(54, 4) + number(40, 4) +
           number(static_cast<std::uint64_t>(w), 4) +
           number(static_cast<std::uint64_t>(from_top ? -h : h), 4) + number(1, 2) + number(24, 2) +
           number(0, 4) + number(data.size(), 4) + number(0, 16) + data;
}

std::string pfm_file(const FloatImage& upright) {
    std::string bytes =
        "PF\n" + std::to_string(upright.size.x) + " " + std::to_string(upright.size.y) + "\n-1.0\n";
    for (int y = upright.size.y - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char*>(pixel(upright, 0, y)),
                     static_cast<std::size_t>(upright.size.x) * 3 * sizeof(float));
    return bytes;
}

std::string dds_file(const FloatImage& upright) {
    constexpr std::uint64_t flags = 0x100F, rgb = 0x40, texture = 0x1000;
    const auto w = static_cast<std::uint64_t>(upright.size.x), h = static_cast<std::uint64_t>(upright.size.y);
    std::string bytes = "DDS " + number(124, 4) + number(flags, 4) + number(h, 4) + number(w, 4) +
                        number(3 * w, 4) + number(0, 52) + number(32, 4) + number(rgb, 4) + number(0, 4) +
                        number(24, 4) + number(0xFF0000, 4) + number(0xFF00, 4) + number(0xFF, 4) +
                        number(0, 4) + number(texture, 4) + number(0, 16);
    for (int y = 0; y < upright.size.y; ++y)
        for (int x = 0; x < upright.size.x; ++x) bytes += bgr(pixel(upright, x, y));
    return bytes;
}

std::string psd_file(const FloatImage& upright) {
    std::string bytes = "8BPS" + number(1, 2, true) + number(0, 6) + number(3, 2, true) +
                        number(static_cast<std::uint64_t>(upright.size.y), 4, true) +
                        number(static_cast<std::uint64_t>(upright.size.x), 4, true) + number(8, 2, true) +
                        number(3, 2, true) + number(0, 12) + number(0, 2);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < upright.size.y; ++y)
            for (int x = 0; x < upright.size.x; ++x) bytes += byte(pixel(upright, x, y)[c]);
    return bytes;
}

std::string exr_file(const FloatImage& upright, int attributes) {
    const auto [w, h] =
        std::pair(static_cast<std::size_t>(upright.size.x), static_cast<std::size_t>(upright.size.y));
    const auto attribute = [](const std::string& name, const std::string& type, const std::string& data) {
        return name + '\0' + type + '\0' + number(data.size(), 4) + data;
    };
    std::string channels;
    for (const char* name : {"B", "G", "R"})
        channels += std::string(name) + '\0' + number(2, 4) + number(0, 4) + number(1, 4) + number(1, 4);
    const std::string window = number(0, 8) + number(w - 1, 4) + number(h - 1, 4);
    std::string bytes = number(20000630, 4) + number(2, 4);
    for (int i = 0; i < attributes; ++i)
        bytes += attribute("attribute" + std::to_string(i), "int", number(1, 4));
    bytes += attribute("channels", "chlist", channels + '\0') +
             attribute("compression", "compression", number(0, 1)) +
             attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
             attribute("lineOrder", "lineOrder", number(0, 1)) +
             attribute("pixelAspectRatio", "float", number(0x3F800000, 4)) +
             attribute("screenWindowCenter", "v2f", number(0, 8)) +
             attribute("screenWindowWidth", "float", number(0x3F800000, 4)) + '\0';
    const std::size_t line = 8 + 12 * w, data = bytes.size() + 8 * h;
    for (std::size_t y = 0; y < h; ++y) bytes += number(data + y * line, 8);
    for (std::size_t y = 0; y < h; ++y) {
        bytes += number(y, 4) + number(12 * w, 4);
        for (int c = 2; c >= 0; --c)
            for (std::size_t x = 0; x < w; ++x)
                bytes.append(reinterpret_cast<const char*>(&pixel(upright, int(x), int(y))[c]), 4);
    }
    return bytes;
}

std::string exif_block(int orientation) {
    return "MM" + number(42, 2, true) + number(8, 4, true) + number(1, 2, true) + number(0x0112, 2, true) +
           number(3, 2, true) + number(1, 4, true) +
           number(static_cast<std::uint64_t>(orientation), 2, true) + number(0, 2) + number(0, 4);
}

std::string with_png_chunk(const std::string& png, const std::string& name, const std::string& data) {
    constexpr std::size_t header_end = 33;
    const std::string chunk =
        number(data.size(), 4, true) + name + data + number(png_checksum(name + data), 4, true);
    return png.substr(0, header_end) + chunk + png.substr(header_end);
}

std::string with_webp_exif(const std::string& webp, glm::ivec2 size, int orientation) {
    const std::string exif = exif_block(orientation);
    const std::string body = "WEBPVP8X" + number(10, 4) + number(0x08, 4) +
                             number(static_cast<std::uint64_t>(size.x - 1), 3) +
                             number(static_cast<std::uint64_t>(size.y - 1), 3) + webp.substr(12) + "EXIF" +
                             number(exif.size(), 4) + exif;
    return "RIFF" + number(body.size(), 4) + body;
}

}  // namespace nacre::test
