#include "core/exchange/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/design/error.h"
#include "core/exchange/file_ending.h"

namespace nacre {

namespace fs = std::filesystem;

ImageFormat image_format(const fs::path& file) {
    const std::string ending = ending_of(file);
    if (ending == ".png") return ImageFormat::png;
    if (ending == ".exr") return ImageFormat::exr;
    throw UserError(file.string(), "write", "the name of a picture must end in .png or .exr", ending);
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
