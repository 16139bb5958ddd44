#include "core/image/picture.h"

namespace nacre {

const std::vector<std::string>& picture_extensions() {
    static const std::vector<std::string> extensions = {
        ".exr", ".hdr", ".tif", ".tiff", ".pfm", ".ppm", ".png",  ".jpg",  ".jpeg", ".webp",
        ".tga", ".bmp", ".psd", ".dds",  ".jp2", ".j2k", ".heic", ".heif", ".avif"};
    return extensions;
}

}  // namespace nacre
