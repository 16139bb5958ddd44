#include "app/designer/plot_saving.h"

#include <system_error>
#include <utility>

#include "app/designer/folder.h"
#include "core/design/error.h"
#include "core/exchange/plot_files.h"

namespace nacre {

namespace fs = std::filesystem;

namespace {

ui::Listing list_plots(const fs::path& folder) { return list_folder(folder, {".svg", ".csv"}); }

}  // namespace

void PlotSaving::ask(Plot plot, const ShapeView& view, const std::string& name) {
    plot_ = std::move(plot);
    view_ = view;
    dialog_ = ui::FileDialog{.purpose = ui::FileDialog::Purpose::save,
                             .listing = list_plots(folder_),
                             .path = name,
                             .problem = {},
                             .title = "Save plot as",
                             .hint = "name or path of a .svg or .csv file"};
}

std::optional<std::string> PlotSaving::draw() {
    if (!problem_.empty() || overwrite_) return draw_questions();
    if (!dialog_) return {};
    fs::path chosen;
    const ui::DialogAnswer answer = ui::file_dialog(*dialog_, list_plots, chosen);
    if (answer == ui::DialogAnswer::cancelled) dialog_.reset();
    if (answer != ui::DialogAnswer::accepted) return {};
    dialog_.reset();
    if (!chosen.has_extension()) chosen += ".svg";
    std::error_code error;
    if (!fs::exists(chosen, error)) return write(chosen);
    overwrite_ = chosen;
    return {};
}

std::optional<std::string> PlotSaving::write(const fs::path& file) {
    try {
        write_plot(file, plot_, view_);
        folder_ = file.parent_path();
        return "Saved " + file.filename().string();
    } catch (const UserError& error) {
        problem_ = error.what();
        return {};
    }
}

std::optional<std::string> PlotSaving::draw_questions() {
    if (!problem_.empty()) {
        if (ui::question("That did not work", problem_, {"OK"})) problem_.clear();
        return {};
    }
    const auto answer = ui::question("Overwrite?", overwrite_->filename().string() + " exists already.",
                                     {"Overwrite", "Cancel"});
    if (!answer) return {};
    const fs::path file = *std::exchange(overwrite_, std::nullopt);
    if (*answer == 0) return write(file);
    return {};
}

}  // namespace nacre
