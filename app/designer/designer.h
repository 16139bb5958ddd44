// The designer without a window. The host owns the Dear ImGui context, its input and its renderer; a
// frame is drawn between ImGui::NewFrame and ImGui::Render.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/designer/bake_job.h"
#include "app/designer/canvas_pane.h"
#include "app/designer/document.h"
#include "app/designer/environment_panel.h"
#include "app/designer/file_flow.h"
#include "app/designer/folder.h"
#include "app/designer/layout.h"
#include "app/designer/object_chooser.h"
#include "app/designer/picture_drop.h"
#include "app/designer/preview_pane.h"
#include "app/preview/scene.h"
#include "ui/commands.h"
#include "ui/layers_panel.h"

namespace nacre {

struct Designer {
    // 0 threads: as many as the machine has. The worker gives way to drawing by its nice level.
    explicit Designer(int bake_threads = 0);

    Document document;
    Scene scene;
    BakeJob baker;
    PreviewPane preview;
    CanvasPane canvas;
    FileFlow files;
    PictureDrop pictures;
    ObjectChooser objects;
    EnvironmentPanel environment;
    Layout layout;
    ui::LayersView layers;
    std::vector<Preset> presets;
    Distribution last_shown;  // p of the frame before, ...
    double changed_at = 0;    // ... when it last changed, seconds on Dear ImGui's clock, ...
    bool settled = true;      // ... and whether it rests, so that final tables are worth their time
    std::string tables_text;  // the shown tables, for the status line
};

// Draws one frame and acts on its input. Never waits for the worker.
void draw_frame(Designer& designer);

// A file was dropped on the window.
void take_file(Designer& designer, const std::filesystem::path& file);

void perform(Designer& designer, ui::Command command);

// Whether the next frame will differ without any input.
bool in_motion(const Designer& designer);

}  // namespace nacre
