#include "app/designer/changed_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "core/base/error.h"
#include "core/design/design_pictures.h"
#include "core/design/picture_files.h"
#include "ui/dialogs.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t names_max = 6;

std::string names_of(const std::vector<FileChange>& changes) {
    std::string names;
    for (std::size_t i = 0; i < std::min(changes.size(), names_max); ++i)
        names += (i > 0 ? ", \u201c" : "\u201c") + changes[i].file.filename().string() + "\u201d";
    if (changes.size() > names_max) names += fmt::format(" and {} more", changes.size() - names_max);
    return names;
}

// What the file holds now is known, and is not asked about again until it changes once more.
void learn(HeldFiles& held, const FileChange& change) {
    if (!held.contains(change.file)) return;
    if (change.now)
        held[change.file] = *change.now;
    else
        held.erase(change.file);
}

// The design's own among these.
std::vector<fs::path> pictures_among(const std::vector<FileChange>& changes, const Design& design) {
    std::vector<fs::path> files = picture_files(design);
    std::erase_if(files, [&](const fs::path& file) {
        return std::none_of(changes.begin(), changes.end(),
                            [&](const FileChange& change) { return change.file == file; });
    });
    return files;
}

std::optional<int> ask_about_changed(const std::vector<FileChange>& changed) {
    const std::string text = names_of(changed) + (changed.size() > 1 ? " were" : " was") +
                             " changed by another program. Reload takes what is in the files now; for the "
                             "design's own pictures Undo brings the old ones back.";
    return ui::question("Files changed on the disk", text, {"Reload", "Keep mine"});
}

std::optional<int> ask_about_gone(const std::vector<FileChange>& gone, bool of_design) {
    std::string text = names_of(gone) + (gone.size() > 1 ? " are" : " is") +
                       " gone from the disk, or cannot be read any more. What is shown stays.";
    if (!of_design) return ui::question("Files gone from the disk", text, {"OK"});
    text += " Hold in design puts the pictures into the design itself: it would not open without them.";
    return ui::question("Files gone from the disk", text, {"Hold in design", "Leave"});
}

}  // namespace

std::vector<FileChange> ChangedPictures::take(bool gone) {
    std::vector<FileChange> taken, others;
    std::partition_copy(changes_.begin(), changes_.end(), std::back_inserter(taken),
                        std::back_inserter(others),
                        [gone](const FileChange& change) { return change.now.has_value() != gone; });
    changes_ = std::move(others);
    return taken;
}

std::optional<std::string> ChangedPictures::draw(Document& document, EnvironmentPanel& environment,
                                                 ObjectChooser& objects) {
    if (!problem_.empty()) {
        if (ui::question("Cannot read the picture again", problem_, {"OK"})) problem_.clear();
        return {};
    }
    const bool gone =
        std::none_of(changes_.begin(), changes_.end(), [](const FileChange& change) { return change.now; });
    std::vector<FileChange> asked = take(gone);
    const std::vector<fs::path> pictures = pictures_among(asked, document.design);
    const auto answer = gone ? ask_about_gone(asked, !pictures.empty()) : ask_about_changed(asked);
    if (!answer) {
        std::move(asked.begin(), asked.end(), std::back_inserter(changes_));
        return {};
    }
    const bool reload = !gone && *answer == 0, hold = gone && *answer == 0 && !pictures.empty();
    for (const FileChange& change : asked) {
        if (reload && environment.held().contains(change.file)) environment.want(change.file.string());
        if (reload && objects.held().contains(change.file)) objects.want(change.file.string());
        for (HeldFiles* held : {&document.held, &environment.held(), &objects.held()}) learn(*held, change);
    }
    if (!reload && !hold) return {};
    try {
        document.commit();
        document.doing = hold ? "Hold pictures" : "Reload pictures";
        document.design = hold ? with_pictures_held(document.design, pictures)
                               : with_pictures_reread(document.design, pictures, document.file.string());
        document.commit();
        return (hold ? "Held in the design: " : "Reloaded ") + names_of(asked);
    } catch (const std::exception&) {
        problem_ = problem_line();
        return {};
    }
}

}  // namespace nacre
