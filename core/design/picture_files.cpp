#include "core/design/picture_files.h"

#include <algorithm>

#include "core/design/design_pictures.h"

namespace nacre {
namespace {

using Files = std::vector<std::filesystem::path>;

void add_once(Files& files, const std::filesystem::path& file) {
    if (!file.empty() && std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

}  // namespace

Files picture_files(const Design& design) {
    Files files;
    for_each_picture(design,
                     [&](const Picture& picture, const std::string&) { add_once(files, picture.file); });
    return files;
}

Files source_files(const Design& design) {
    Files files;
    for (const Layer& layer : design.distribution.layers)
        if (layer.source) add_once(files, layer.source->image);
    return files;
}

}  // namespace nacre
