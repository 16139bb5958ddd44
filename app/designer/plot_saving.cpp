#include "app/designer/plot_saving.h"

#include <exception>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/system/output_guard.h"
#include "core/formats/plot_files.h"

namespace nacre {

namespace fs = std::filesystem;

void PlotSaving::ask(Plot plot, const ShapeView& view, const std::string& name,
                     const std::optional<DialogProgram>& dialogs) {
    plot_ = std::move(plot);
    view_ = view;
    chooser_.ask({.purpose = ui::FileDialog::Purpose::save,
                  .title = "Save plot as",
                  .folder = folder_,
                  .name = name,
                  .kind = "Plot, SVG or CSV",
                  .extensions = {".svg", ".csv"}},
                 dialogs);
}

std::optional<std::string> PlotSaving::draw() {
    if (!problem_.empty() || overwrite_) return draw_questions();
    const auto answer = chooser_.draw();
    if (!answer || answer->chosen.empty()) return {};
    std::error_code error;
    if (!fs::exists(answer->chosen, error)) return write(answer->chosen);
    overwrite_ = answer->chosen;
    return {};
}

std::optional<std::string> PlotSaving::write(const fs::path& file) {
    try {
        check_outputs({file}, inputs_());
        write_plot(file, plot_, view_);
        folder_ = file.parent_path();
        return "Saved " + file.filename().string();
    } catch (const std::exception&) {
        problem_ = problem_line();
        return {};
    }
}

std::optional<std::string> PlotSaving::draw_questions() {
    if (!problem_.empty()) {
        if (ui::question("Cannot save the plot", problem_, {"OK"})) problem_.clear();
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
