#include "app/designer/file_chooser.h"

#include <utility>

#include "app/designer/folder.h"

namespace nacre {

namespace fs = std::filesystem;
using Purpose = ui::FileDialog::Purpose;

void FileChooser::ask(FileQuestion question, const std::optional<DialogProgram>& program) {
    question_ = std::move(question);
    question_.folder = existing_folder(question_.folder);
    if (program)
        system_ = std::make_unique<SystemDialog>(*program, question_);
    else
        browse();
}

ui::Listing FileChooser::list(const fs::path& folder) const {
    return list_folder(folder, question_.extensions);
}

void FileChooser::browse() {
    const std::string what = question_.kind.empty() ? "" : question_.kind + ": ";
    const bool folder = question_.purpose == Purpose::folder;
    browser_ = ui::FileDialog{.purpose = question_.purpose,
                              .listing = list(question_.folder),
                              .path = question_.name,
                              .problem = {},
                              .title = question_.title,
                              .hint = what + (folder ? "a folder's name or path" : "a file's name or path")};
}

FileChooser::Answer FileChooser::chosen(fs::path file) const {
    const std::vector<std::string>& extensions = question_.extensions;
    if (question_.purpose == Purpose::save && !extensions.empty() && !has_extension(file, extensions))
        file += extensions.front();
    return {std::move(file)};
}

bool FileChooser::has_answer() const { return system_ && system_->poll() != SystemDialog::State::open; }

std::optional<FileChooser::Answer> FileChooser::draw_system() {
    const SystemDialog::State state = system_->poll();
    const bool given_up =
        state == SystemDialog::State::open &&
        ui::question(question_.title.c_str(), "The file dialog is open in a window of its own.", {"Cancel"});
    if (state == SystemDialog::State::open && !given_up) return {};
    const std::unique_ptr<SystemDialog> ended = std::move(system_);
    if (state == SystemDialog::State::accepted) return chosen(ended->chosen());
    if (state != SystemDialog::State::failed) return Answer{};
    browse();
    return {};
}

std::optional<FileChooser::Answer> FileChooser::draw() {
    if (system_) return draw_system();
    if (!browser_) return {};
    fs::path file;
    const ui::DialogAnswer answer = ui::file_dialog(
        *browser_, [this](const fs::path& folder) { return list(folder); }, file);
    if (answer == ui::DialogAnswer::none) return {};
    browser_.reset();
    return answer == ui::DialogAnswer::accepted ? chosen(std::move(file)) : Answer{};
}

}  // namespace nacre
