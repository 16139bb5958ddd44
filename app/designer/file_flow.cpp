#include "app/designer/file_flow.h"

#include <system_error>
#include <utility>

#include "app/designer/folder.h"
#include "core/design/design_file.h"
#include "core/design/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

std::string design_name(const Document& document) {
    return document.design.name.empty() ? "Untitled" : document.design.name;
}

// Whether the file holds this very design.
bool is_on_disk(const Design& design, const fs::path& file) {
    try {
        return !file.empty() && load_work(file) == design;
    } catch (const UserError&) {
        return false;
    }
}

}  // namespace

void FileFlow::start_new(Document& document) { lose_work_for(Next::begin_new, document); }

void FileFlow::start_open(Document& document) { lose_work_for(Next::show_open, document); }

void FileFlow::open_file(Document& document, const fs::path& file) {
    if (talking()) return;
    to_open_ = fs::absolute(file).lexically_normal();
    lose_work_for(Next::open, document);
}

void FileFlow::open_preset(Document& document, const fs::path& file) {
    if (talking()) return;
    to_open_ = file;
    lose_work_for(Next::open_preset, document);
}

void FileFlow::restore(Document& document, LostAndFound found) {
    to_restore_ = std::move(found);
    lose_work_for(Next::restore, document);
}

void FileFlow::quit(Document& document) { lose_work_for(Next::quit, document); }

void FileFlow::save(Document& document) {
    if (document.file.empty())
        save_as(document);
    else
        write(document, document.file);
}

fs::path FileFlow::folder(const Document& document) const {
    fs::path folder = document.file.parent_path();
    if (folder.empty() && memory_.settings != nullptr) folder = memory_.settings->design_folder;
    folder = existing_folder(folder);
    return folder.empty() ? memory_.home : folder;
}

void FileFlow::save_as(const Document& document) {
    if (talking()) return;
    saving_ = true;
    chooser_.ask({.purpose = ui::FileDialog::Purpose::save,
                  .title = "Save design as",
                  .folder = folder(document),
                  .name = document.stem() + design_extension,
                  .kind = "Nacre design",
                  .endings = {design_extension}},
                 memory_.dialogs);
}

void FileFlow::lose_work_for(Next next, Document& document) {
    if (talking()) return;
    document.commit();
    next_ = next;
    if (document.unsaved())
        asking_unsaved_ = true;
    else
        go_on(document);
}

void FileFlow::go_on(Document& document) {
    switch (std::exchange(next_, Next::nothing)) {
        case Next::nothing:
            break;
        case Next::begin_new:
            document = Document();
            message_ = "New design";
            break;
        case Next::show_open:
            saving_ = false;
            chooser_.ask({.purpose = ui::FileDialog::Purpose::open,
                          .title = "Open design",
                          .folder = folder(document),
                          .kind = "Nacre design",
                          .endings = {design_extension}},
                         memory_.dialogs);
            break;
        case Next::open:
            load(document, false);
            break;
        case Next::open_preset:
            load(document, true);
            break;
        case Next::restore:
            become_restored(document);
            break;
        case Next::quit:
            may_quit_ = true;
            break;
    }
}

// A preset opens as a new design: saving it must not change what comes with the program.
void FileFlow::load(Document& document, bool as_preset) {
    try {
        document = Document(load_work(to_open_), as_preset ? fs::path() : to_open_);
        if (as_preset) document.preset = to_open_;
        message_ = "Opened " + to_open_.filename().string();
        if (!as_preset) note(to_open_);
    } catch (const UserError& error) {
        problem_ = error.what();
        std::error_code gone;
        if (memory_.recent != nullptr && !fs::exists(to_open_, gone)) memory_.recent->forget(to_open_);
    }
}

void FileFlow::become_restored(Document& document) {
    const UnsavedWork& work = to_restore_->work;
    document = Document(work.design, work.file);
    if (!is_on_disk(work.design, work.file)) document.mark_unsaved();
    message_ = "Restored " + design_name(document);
    restored_ = std::exchange(to_restore_, std::nullopt);
}

void FileFlow::write(Document& document, const fs::path& file) {
    try {
        document.commit();
        save_design(document.design, file);
        document.file = file;
        document.history.mark_saved();
        message_ = "Saved " + file.filename().string();
        note(file);
        go_on(document);
    } catch (const UserError& error) {
        problem_ = error.what();
        next_ = Next::nothing;
    }
}

void FileFlow::note(const fs::path& file) {
    if (memory_.recent != nullptr) memory_.recent->note(file);
    if (memory_.settings != nullptr) memory_.settings->design_folder = file.parent_path();
}

void FileFlow::draw(Document& document) {
    draw_questions(document);
    if (chooser_.open() && !overwrite_ && problem_.empty()) draw_dialog(document);
    if (!talking() && next_ == Next::nothing) to_restore_.reset();
}

void FileFlow::draw_dialog(Document& document) {
    const auto answer = chooser_.draw();
    if (!answer) return;
    const fs::path& chosen = answer->chosen;
    if (chosen.empty()) {
        next_ = Next::nothing;
        return;
    }
    if (!saving_) {
        to_open_ = chosen;
        load(document, false);
        return;
    }
    std::error_code error;
    if (chosen != document.file && fs::exists(chosen, error))
        overwrite_ = chosen;
    else
        write(document, chosen);
}

void FileFlow::draw_unsaved_question(Document& document) {
    const std::string text = "\u201c" + design_name(document) + "\u201d has changes that are not saved.";
    const auto answer = ui::question("Unsaved changes", text, {"Save", "Discard", "Cancel"});
    if (!answer) return;
    asking_unsaved_ = false;
    if (*answer == 0) save(document);
    if (*answer == 1) go_on(document);
    if (*answer == 2) next_ = Next::nothing;
}

void FileFlow::draw_questions(Document& document) {
    if (!problem_.empty()) {
        if (ui::question("That did not work", problem_, {"OK"})) problem_.clear();
    } else if (asking_unsaved_) {
        draw_unsaved_question(document);
    } else if (overwrite_) {
        const auto answer = ui::question("Overwrite?", overwrite_->filename().string() + " exists already.",
                                         {"Overwrite", "Cancel"});
        if (!answer) return;
        const fs::path file = *std::exchange(overwrite_, std::nullopt);
        if (*answer == 0)
            write(document, file);
        else
            save_as(document);
    }
}

}  // namespace nacre
