// Where a plot is saved, as a conversation.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/plot/draw_plot.h"
#include "ui/dialogs.h"

namespace nacre {

class PlotSaving {
  public:
    // The plot as it is now, under a name that is suggested.
    void ask(Plot plot, const ShapeView& view, const std::string& name);

    // Draws what is open. Returns what was done, once.
    std::optional<std::string> draw();

    bool talking() const { return dialog_ || overwrite_ || !problem_.empty(); }

  private:
    std::optional<std::string> write(const std::filesystem::path& file);
    std::optional<std::string> draw_questions();

    Plot plot_;
    ShapeView view_;
    std::optional<ui::FileDialog> dialog_;
    std::optional<std::filesystem::path> overwrite_;
    std::filesystem::path folder_;  // of the last plot
    std::string problem_;
};

}  // namespace nacre
