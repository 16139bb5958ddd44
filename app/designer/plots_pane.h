// The plots of the newest tables, made only while they are seen and only when something has changed.
#pragma once

#include <memory>
#include <optional>

#include "app/designer/plot_saving.h"
#include "app/preview/gl_objects.h"
#include "ui/plots_panel.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class PlotsPane {
  public:
    ui::PlotsState state;
    PlotSaving saving;

    // Whether what is shown needs R.
    bool wants_albedo() const { return state.open && needs_albedo(state.settings); }

    // Fills the current Dear ImGui window. `name`: what a saved plot's name begins with; `dialogs` asks
    // where.
    void draw(const std::shared_ptr<const Tables>& tables, const std::string& name,
              const std::optional<DialogProgram>& dialogs);

    // What is under the pointer, as it was drawn last.
    const std::optional<PlotReading>& reading() const { return reading_; }
    const std::optional<Plot>& plot() const { return plot_; }

  private:
    void update(const std::shared_ptr<const Tables>& tables);

    std::shared_ptr<const Tables> plotted_;  // that plot_ is for, ...
    PlotSettings settings_;                  // ... and how
    std::optional<Plot> plot_;
    Texture slice_;
    std::optional<PlotReading> reading_;
};

}  // namespace nacre
