#include "core/design/picture_files.h"

#include <algorithm>

#include "core/design/design_pictures.h"

namespace nacre {

std::vector<std::filesystem::path> picture_files(const Design& design) {
    std::vector<std::filesystem::path> files;
    const auto add = [&](const Picture& picture, const std::string&) {
        if (!picture.file.empty() && std::find(files.begin(), files.end(), picture.file) == files.end())
            files.push_back(picture.file);
    };
    for_each_picture(design, add);
    return files;
}

}  // namespace nacre
