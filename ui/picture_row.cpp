#include "ui/picture_row.h"

#include "ui/widgets.h"

namespace nacre::ui {

std::string picture_text(const Picture& picture) {
    std::string where = picture.file.empty() ? "in the design" : picture.file.filename().string();
    if (!picture.raster) return where;
    return where + ", " + std::to_string(picture.raster->width) + " \u00d7 " +
           std::to_string(picture.raster->height);
}

void picture_row(const char* label, const Picture& picture) {
    text_row(label, picture_text(picture));
    notes_row(picture.notes);
}

}  // namespace nacre::ui
