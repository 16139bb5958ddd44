#include "app/designer/screenshot_saver.h"

#include <exception>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/system/atomic_file.h"
#include "core/base/system/output_folder.h"
#include "core/image/image_file.h"

namespace nacre {

namespace fs = std::filesystem;

void ScreenshotSaver::ask(const Document& document) {
    asking_ = false;
    fs::path folder = settings_->picture_folder;
    if (folder.empty()) folder = document.file.parent_path();
    if (folder.empty()) folder = settings_->design_folder;
    chooser_.ask({.purpose = ui::FileDialog::Purpose::folder, .title = "Screenshot folder", .folder = folder},
                 dialogs_);
}

// Drawn at once, coded and written on a thread of its own.
void ScreenshotSaver::begin(const Document& document, PreviewPane& preview, const Scene& scene) {
    wanted_ = false;
    if (!preview.has_picture()) {
        problem_ = "There is no picture yet.";
        return;
    }
    try {
        task_.start([image = preview.picture(scene, preview.size(), false),
                     folder = settings_->picture_folder, stem = document.stem()](const auto&, const auto&) {
            const OutputFolder made(folder);
            const ImageBytes bytes = image_bytes(ImageFormat::png, image.size, image.rgb);
            const fs::path file = write_numbered_file(folder, stem, ".png", text_of(bytes));
            return "Picture " + file.string();
        });
    } catch (const std::exception&) {
        problem_ = problem_line();
    }
}

std::optional<std::string> ScreenshotSaver::draw(const Document& document, PreviewPane& preview,
                                                 const Scene& scene) {
    if (!problem_.empty()) {
        if (ui::question("Cannot save the preview image", problem_, {"OK"})) problem_.clear();
        return {};
    }
    if (const auto ended = task_.poll()) {
        problem_ = ended->problem;
        if (problem_.empty()) return ended->message;
    }
    if (asking_ || (wanted_ && settings_->picture_folder.empty() && !chooser_.open())) ask(document);
    if (chooser_.open()) {
        const auto answer = chooser_.draw();
        if (!answer) return {};
        wanted_ = wanted_ && !answer->chosen.empty();
        if (answer->chosen.empty()) return {};
        settings_->picture_folder = answer->chosen;
        if (!wanted_) return "Pictures go to " + answer->chosen.string();
    }
    if (wanted_ && !task_.busy()) begin(document, preview, scene);
    return {};
}

}  // namespace nacre
