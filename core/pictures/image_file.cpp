#include "core/exchange/image_file.h"

#include <OpenImageIO/imageio.h>

#include <cstdint>

#include "core/design/error.h"
#include "core/exchange/atomic_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

void write_with(const char* format, const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                const void* pixels) {
    write_file_atomically(file, [&](const fs::path& temporary) {
        const auto output = OIIO::ImageOutput::create(format);
        const bool written = output && output->open(temporary.string(), spec) &&
                             output->write_image(type, pixels) && output->close();
        if (!written)
            throw UserError(file.string(), "write", "the picture cannot be written",
                            output ? output->geterror() : OIIO::geterror());
    });
}

std::size_t pixel_count(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

void write_png(const fs::path& file, glm::ivec2 size, std::span<const std::uint8_t> pixels) {
    const std::size_t stride = pixels.size() / pixel_count(size);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * pixel_count(size));
    for (std::size_t i = 0; i < pixel_count(size); ++i)
        for (std::size_t c = 0; c < 3; ++c) rgb.push_back(pixels[i * stride + c]);
    OIIO::ImageSpec spec(size.x, size.y, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    write_with("png", file, spec, OIIO::TypeDesc::UINT8, rgb.data());
}

void write_exr(const fs::path& file, glm::ivec2 size, const std::vector<std::string>& channels,
               std::span<const float> values) {
    OIIO::ImageSpec spec(size.x, size.y, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = channels;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // else the time of writing: the same picture is the same file
    spec.attribute("oiio:ColorSpace", "Linear");
    write_with("openexr", file, spec, OIIO::TypeDesc::FLOAT, values.data());
}

}  // namespace nacre
