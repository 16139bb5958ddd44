#include "tests/gl/read_png.h"

#include <OpenImageIO/imageio.h>

namespace nacre::test {

std::vector<float> read_png(const std::filesystem::path& file, glm::ivec2 size) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input || input->spec().width != size.x || input->spec().height != size.y ||
        input->spec().nchannels < 3)
        return {};
    std::vector<float> rgb(static_cast<std::size_t>(size.x * size.y * 3));
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, rgb.data())) return {};
    return rgb;
}

}  // namespace nacre::test
