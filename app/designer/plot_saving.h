// Where a plot is saved, as a conversation.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/designer/file_chooser.h"
#include "core/plot/draw_plot.h"

namespace nacre {

class PlotSaving {
  public:
    // The plot as it is now, under a name that is suggested; `dialogs` asks for it.
    void ask(Plot plot, const ShapeView& view, const std::string& name,
             const std::optional<DialogProgram>& dialogs);

    void remember(std::function<std::vector<std::filesystem::path>()> inputs) { inputs_ = std::move(inputs); }

    // Draws what is open. Returns what was done, once.
    std::optional<std::string> draw();

    bool talking() const { return chooser_.open() || overwrite_ || !problem_.empty(); }
    bool in_motion() const { return chooser_.has_answer(); }
    const std::string& problem() const { return problem_; }  // shown until it is read

  private:
    std::optional<std::string> write(const std::filesystem::path& file);
    std::optional<std::string> draw_questions();

    std::function<std::vector<std::filesystem::path>()> inputs_;  // never written: see output_guard.h
    Plot plot_;
    ShapeView view_;
    FileChooser chooser_;
    std::optional<std::filesystem::path> overwrite_;
    std::filesystem::path folder_;  // of the last plot
    std::string problem_;
};

}  // namespace nacre
