#include "app/designer/picture_notes.h"

#include <set>

#include "core/design/design_pictures.h"

namespace nacre {

namespace fs = std::filesystem;

std::string notes_line(const fs::path& file, const PictureNotes& notes) {
    std::string line;
    for (const std::string& note : notes)
        line += (line.empty() ? file.filename().string() + ": " : "; ") + note;
    return line;
}

std::string notes_line(const Design& design) {
    std::string line;
    std::set<fs::path> told;
    for_each_picture(design, [&](const Picture& picture, const std::string&) {
        if (picture.file.empty() || picture.notes.empty() || !told.insert(picture.file).second) return;
        line += (line.empty() ? "" : "; ") + notes_line(picture.file, picture.notes);
    });
    return line;
}

}  // namespace nacre
