#include "core/image/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/system/atomic_file.h"

namespace nacre {

namespace fs = std::filesystem;

ImageFormat image_format(const fs::path& file) {
    const std::string extension = extension_of(file);
    if (extension == ".png") return ImageFormat::png;
    if (extension == ".exr") return ImageFormat::exr;
    throw UserError(file.string(), "write", "the name of a picture must end in .png or .exr", extension);
}

std::string_view text_of(const ImageBytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ImageBytes image_bytes(ImageFormat format, glm::ivec2 size, std::span<const float> rgb) {
    if (format == ImageFormat::exr) return exr_bytes(size, {"R", "G", "B"}, rgb);
    std::vector<std::uint8_t> pixels(rgb.size());
    std::transform(rgb.begin(), rgb.end(), pixels.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
    });
    return png_bytes(size, pixels);
}

void write_image(const fs::path& file, glm::ivec2 size, std::span<const float> rgb) {
    write_file_atomically(file, text_of(image_bytes(image_format(file), size, rgb)));
}

}  // namespace nacre
