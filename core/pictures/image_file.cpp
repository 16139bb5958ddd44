#include "core/image/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <stdexcept>

namespace nacre {
namespace {

ImageBytes encode(const char* format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
    ImageBytes bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format);
    const bool encoded = output && output->set_ioproxy(&memory) && output->open(format, spec) &&
                         output->write_image(type, pixels) && output->close();
    if (!encoded)
        throw std::runtime_error("the picture cannot be encoded: " +
                                 (output ? output->geterror() : OIIO::geterror()));
    return bytes;
}

std::size_t pixel_count(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

ImageBytes png_bytes(glm::ivec2 size, std::span<const std::uint8_t> pixels) {
    const std::size_t stride = pixels.size() / pixel_count(size);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * pixel_count(size));
    for (std::size_t i = 0; i < pixel_count(size); ++i)
        for (std::size_t c = 0; c < 3; ++c) rgb.push_back(pixels[i * stride + c]);
    OIIO::ImageSpec spec(size.x, size.y, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return encode("png", spec, OIIO::TypeDesc::UINT8, rgb.data());
}

ImageBytes exr_bytes(glm::ivec2 size, const std::vector<std::string>& channels,
                     std::span<const float> values) {
    OIIO::ImageSpec spec(size.x, size.y, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = channels;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // else the time of writing: the same picture is the same file
    spec.attribute("oiio:ColorSpace", "Linear");
    return encode("openexr", spec, OIIO::TypeDesc::FLOAT, values.data());
}

}  // namespace nacre
