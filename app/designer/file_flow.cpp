#include "app/designer/file_flow.h"

#include <system_error>
#include <utility>

#include "app/designer/folder.h"
#include "core/design/design_file.h"
#include "core/design/error.h"

namespace nacre {

namespace fs = std::filesystem;

void FileFlow::start_new(Document& document) { lose_work_for(Next::begin_new, document); }

void FileFlow::start_open(Document& document) { lose_work_for(Next::show_open, document); }

void FileFlow::open_file(Document& document, const fs::path& file) {
    to_open_ = file;
    lose_work_for(Next::open, document);
}

void FileFlow::open_preset(Document& document, const fs::path& file) {
    to_open_ = file;
    lose_work_for(Next::open_preset, document);
}

void FileFlow::quit(Document& document) { lose_work_for(Next::quit, document); }

void FileFlow::save(Document& document) {
    if (document.file.empty())
        save_as(document);
    else
        write(document, document.file);
}

void FileFlow::save_as(const Document& document) {
    const fs::path folder = document.file.empty() ? last_folder_ : document.file.parent_path();
    ui::FileDialog dialog{
        .purpose = ui::FileDialog::Purpose::save, .listing = list_designs(folder), .path = {}, .problem = {}};
    dialog.path = document.file.empty() ? "untitled.nacre" : document.file.filename().string();
    dialog_ = std::move(dialog);
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
            dialog_ = ui::FileDialog{.purpose = ui::FileDialog::Purpose::open,
                                     .listing = list_designs(last_folder_),
                                     .path = {},
                                     .problem = {}};
            break;
        case Next::open:
            load(document, false);
            break;
        case Next::open_preset:
            load(document, true);
            break;
        case Next::quit:
            may_quit_ = true;
            break;
    }
}

// A preset opens as a new design: saving it must not change what comes with the program.
void FileFlow::load(Document& document, bool as_preset) {
    try {
        document = Document(load_design(to_open_), as_preset ? fs::path() : to_open_);
        if (as_preset) document.preset = to_open_;
        message_ = "Opened " + to_open_.filename().string();
        if (!as_preset) last_folder_ = to_open_.parent_path();
    } catch (const UserError& error) {
        problem_ = error.what();
    }
}

void FileFlow::write(Document& document, const fs::path& file) {
    try {
        document.commit();
        save_design(document.design, file);
        document.file = file;
        document.history.mark_saved();
        last_folder_ = file.parent_path();
        message_ = "Saved " + file.filename().string();
        go_on(document);
    } catch (const UserError& error) {
        problem_ = error.what();
        next_ = Next::nothing;
    }
}

void FileFlow::draw(Document& document) {
    draw_questions(document);
    if (dialog_ && !overwrite_ && problem_.empty()) draw_dialog(document);
}

void FileFlow::draw_dialog(Document& document) {
    fs::path chosen;
    const bool saving = dialog_->purpose == ui::FileDialog::Purpose::save;
    const ui::DialogAnswer answer = ui::file_dialog(*dialog_, list_designs, chosen);
    if (answer == ui::DialogAnswer::none) return;
    dialog_.reset();
    if (answer == ui::DialogAnswer::cancelled) {
        next_ = Next::nothing;
        return;
    }
    if (!saving) {
        to_open_ = chosen;
        load(document, false);
        return;
    }
    if (!chosen.has_extension()) chosen += ".nacre";
    std::error_code error;
    if (chosen != document.file && fs::exists(chosen, error))
        overwrite_ = chosen;
    else
        write(document, chosen);
}

void FileFlow::draw_questions(Document& document) {
    if (!problem_.empty()) {
        if (ui::question("That did not work", problem_, {"OK"})) problem_.clear();
    } else if (asking_unsaved_) {
        const std::string text = "\u201c" +
                                 (document.design.name.empty() ? "Untitled" : document.design.name) +
                                 "\u201d has changes that are not saved.";
        const auto answer = ui::question("Unsaved changes", text, {"Save", "Discard", "Cancel"});
        if (!answer) return;
        asking_unsaved_ = false;
        if (*answer == 0) save(document);
        if (*answer == 1) go_on(document);
        if (*answer == 2) next_ = Next::nothing;
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
