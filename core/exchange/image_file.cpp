#include "core/exchange/image_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "core/design/error.h"

namespace nacre {

namespace fs = std::filesystem;

ImageFormat image_format(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") return ImageFormat::png;
    if (extension == ".exr") return ImageFormat::exr;
    throw UserError(file.string(), "write", "the name of a picture must end in .png or .exr", extension);
}

void write_image(const fs::path& file, glm::ivec2 size, std::span<const float> rgb) {
    if (image_format(file) == ImageFormat::exr) {
        write_exr(file, size, {"R", "G", "B"}, rgb);
        return;
    }
    std::vector<std::uint8_t> bytes(rgb.size());
    std::transform(rgb.begin(), rgb.end(), bytes.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
    });
    write_png(file, size, bytes);
}

}  // namespace nacre
