#include "core/design/picture_files.h"

#include <algorithm>

namespace nacre {

std::vector<std::filesystem::path> picture_files(const Design& design) {
    std::vector<std::filesystem::path> files;
    const auto add = [&](const Picture& picture) {
        if (!picture.file.empty() && std::find(files.begin(), files.end(), picture.file) == files.end())
            files.push_back(picture.file);
    };
    for (const Layer& layer : design.distribution.layers) {
        if (const auto* const painted = std::get_if<PaintedLobe>(&layer.lobe)) add(painted->image);
        if (layer.modulation) add(layer.modulation->image);
    }
    return files;
}

}  // namespace nacre
