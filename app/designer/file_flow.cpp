#include "app/designer/file_flow.h"

#include <exception>
#include <system_error>
#include <utility>

#include "app/designer/change_question.h"
#include "app/designer/folder.h"
#include "app/designer/picture_notes.h"
#include "app/designer/recovery.h"
#include "app/designer/unsaved_question.h"
#include "core/base/error.h"
#include "core/base/system/output_guard.h"
#include "core/design/design_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

std::string name_of(const Design& design) { return design.name.empty() ? "Untitled" : design.name; }

// And what is to be said of the pictures that were read with it.
std::string with_notes(const std::string& message, const Document& document) {
    const std::string notes = notes_line(document.design);
    return notes.empty() ? message : message + "; " + notes;
}

}  // namespace

void FileFlow::start_new(Document& document) { lose_work_for(Next::begin_new, document); }

void FileFlow::start_open(Document& document) { lose_work_for(Next::show_open, document); }

void FileFlow::open_file(Document& document, const fs::path& file) {
    if (talking()) return;
    std::error_code error;
    to_open_ = fs::absolute(file, error).lexically_normal();
    if (error) to_open_ = file;
    lose_work_for(Next::open, document);
}

// Saving it must not change what comes with the program.
void FileFlow::take_preset(Document& document, const fs::path& file) {
    if (talking()) return;
    try {
        Document opened = read_document(file);
        opened.held.erase(file);
        opened.preset = std::exchange(opened.file, fs::path());
        document.begin(opened, "Preset " + name_of(opened.design));
        message_ = with_notes("Began as " + name_of(document.design), document);
    } catch (const std::exception&) {
        problem_ = problem_line();
    }
}

void FileFlow::restore(Document& document, RecoveredWork found) {
    to_restore_ = std::move(found);
    lose_work_for(Next::restore, document);
}

void FileFlow::quit(Document& document) { lose_work_for(Next::quit, document); }

void FileFlow::save(Document& document) {
    if (document.file.empty()) return save_as(document);
    const auto now = content_of_file(document.file);
    if (now != content_in(document.held, document.file))
        changed_ = Changed{.now = now, .saving = true};
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
                  .extensions = {design_extension}},
                 memory_.dialogs);
}

void FileFlow::lose_work_for(Next next, Document& document) {
    if (talking()) return;
    document.commit();
    next_ = next;
    if (document.unsaved())
        asking_unsaved_ = true;
    else
        ask_elsewhere(document);
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
                          .extensions = {design_extension}},
                         memory_.dialogs);
            break;
        case Next::open:
            load(document);
            break;
        case Next::restore:
            become_restored(document);
            break;
        case Next::quit:
            may_quit_ = true;
            break;
    }
}

void FileFlow::load(Document& document) {
    try {
        document = read_document(to_open_);
        message_ = with_notes("Opened " + to_open_.filename().string(), document);
        note(to_open_);
    } catch (const std::exception&) {
        problem_ = problem_line();
        std::error_code gone;
        if (memory_.recent != nullptr && !fs::exists(to_open_, gone)) memory_.recent->forget(to_open_);
    }
}

void FileFlow::become_restored(Document& document) {
    const UnsavedWork& work = to_restore_->work;
    if (auto saved = saved_already(work)) {
        document = *std::move(saved);
    } else {
        document = Document(work.design, work.file, "Restored work");
        document.held = work.held;
        document.mark_unsaved();
    }
    message_ = "Restored " + name_of(document.design);
    if (const std::size_t others = to_restore_->others; others > 0)
        message_ += "; " + std::to_string(others) + " more under File, Recover unsaved work";
    restored_ = std::exchange(to_restore_, std::nullopt);
}

// Says why not.
bool FileFlow::may_write(const fs::path& file) {
    try {
        if (memory_.inputs) check_outputs({file}, memory_.inputs());
        return true;
    } catch (const std::exception&) {
        problem_ = problem_line();
        next_ = Next::nothing;
        return false;
    }
}

void FileFlow::write(Document& document, const fs::path& file) {
    if (!may_write(file)) return;
    try {
        document.commit();
        const FileContent content = save_design(document.design, file);
        document.held.erase(document.file);
        document.held[file] = content;
        document.file = file;
        document.history.mark_saved();
        message_ = "Saved " + file.filename().string();
        note(file);
        ask_elsewhere(document);
    } catch (const std::exception&) {
        problem_ = problem_line();
        next_ = Next::nothing;
    }
}

void FileFlow::reload(Document& document) {
    try {
        document.reload(read_document(document.file));
        message_ = with_notes("Reloaded " + document.file.filename().string(), document);
    } catch (const std::exception&) {
        problem_ = problem_line();
    }
}

void FileFlow::note(const fs::path& file) {
    if (memory_.recent != nullptr) memory_.recent->note(file);
    if (memory_.settings != nullptr) memory_.settings->design_folder = file.parent_path();
}

void FileFlow::draw(Document& document) {
    draw_questions(document);
    if (chooser_.open() && !overwrite_ && !changed_ && problem_.empty()) draw_dialog(document);
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
        load(document);
        return;
    }
    std::error_code error;
    if (chosen == document.file)
        save(document);
    else if (may_write(chosen) && fs::exists(chosen, error))
        overwrite_ = chosen;
    else if (problem_.empty())
        write(document, chosen);
}

void FileFlow::draw_unsaved_question(Document& document) {
    const auto answer = ask_about_unsaved(name_of(document.design));
    if (!answer) return;
    asking_unsaved_ = false;
    if (*answer == UnsavedAnswer::keep) save(document);
    if (*answer == UnsavedAnswer::discard) ask_elsewhere(document);
    if (*answer == UnsavedAnswer::cancel) next_ = Next::nothing;
}

void FileFlow::draw_elsewhere_question(Document& document) {
    std::vector<std::string> names;
    for (const Document::Unsaved& work : document.unsaved_elsewhere()) names.push_back(name_of(*work.design));
    const auto answer = ask_about_unsaved_elsewhere(names);
    if (!answer) return;
    asking_elsewhere_ = false;
    if (*answer == UnsavedAnswer::discard) return go_on(document);
    next_ = Next::nothing;
    if (*answer == UnsavedAnswer::keep) document.go_elsewhere();
}

// Goes on unless a preset took the place of work that is not saved.
void FileFlow::ask_elsewhere(Document& document) {
    if (next_ != Next::nothing && !document.unsaved_elsewhere().empty())
        asking_elsewhere_ = true;
    else
        go_on(document);
}

void FileFlow::draw_changed_question(Document& document) {
    const auto answer = ask_about_change(document.file, !changed_->now, changed_->saving);
    if (!answer) return;
    const Changed asked = *changed_;
    // Whoever changed it may have done so again.
    if (*answer == ChangeAnswer::overwrite && content_of_file(document.file) != asked.now) {
        changed_->now = content_of_file(document.file);
        return;
    }
    if (*answer == ChangeAnswer::keep_mine) document.keep_mine(changed_->now);
    changed_.reset();
    if (*answer == ChangeAnswer::overwrite) return write(document, document.file);
    if (*answer == ChangeAnswer::save_as) return save_as(document);
    next_ = Next::nothing;
    if (*answer == ChangeAnswer::reload) reload(document);
}

void FileFlow::draw_questions(Document& document) {
    if (!problem_.empty()) {
        if (ui::question("Cannot open or save", problem_, {"OK"})) problem_.clear();
    } else if (changed_) {
        draw_changed_question(document);
    } else if (asking_unsaved_) {
        draw_unsaved_question(document);
    } else if (asking_elsewhere_) {
        draw_elsewhere_question(document);
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
