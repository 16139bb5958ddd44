#include "core/design/design_pictures.h"

#include <algorithm>

#include "core/image/picture.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

bool contains(const std::vector<fs::path>& files, const fs::path& file) {
    return std::find(files.begin(), files.end(), file) != files.end();
}

}  // namespace

Design with_pictures_reread(Design design, const std::vector<fs::path>& files,
                            const std::string& error_file) {
    for_each_picture(design, [&](Picture& picture, const std::string& where) {
        if (picture.file.empty() || !contains(files, picture.file)) return;
        picture.raster = load_shared_picture(picture.file, error_file, where, picture.notes);
    });
    return design;
}

Design with_pictures_held(Design design, const std::vector<fs::path>& files) {
    for_each_picture(design, [&](Picture& picture, const std::string&) {
        if (contains(files, picture.file)) picture.file.clear();
    });
    return design;
}

}  // namespace nacre
