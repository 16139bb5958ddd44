// The designer without a window. The host owns the Dear ImGui context, its input and its renderer; a
// frame is drawn between ImGui::NewFrame and ImGui::Render.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/designer/autosave.h"
#include "app/designer/bake_job.h"
#include "app/designer/canvas_pane.h"
#include "app/designer/changed_pictures.h"
#include "app/designer/comparison.h"
#include "app/designer/document.h"
#include "app/designer/environment_panel.h"
#include "app/designer/export_flow.h"
#include "app/designer/file_flow.h"
#include "app/designer/file_watch.h"
#include "app/designer/folder.h"
#include "app/designer/frame.h"
#include "app/designer/image_import.h"
#include "app/designer/layer_remake.h"
#include "app/designer/layout.h"
#include "app/designer/object_chooser.h"
#include "app/designer/plots_pane.h"
#include "app/designer/preset_wall.h"
#include "app/designer/preview_pane.h"
#include "app/designer/recent_files.h"
#include "app/designer/recovery.h"
#include "app/designer/screenshot_saver.h"
#include "app/designer/settings.h"
#include "app/designer/stamp_chooser.h"
#include "app/designer/take_back.h"
#include "app/designer/thumbnails.h"
#include "app/designer/user_folders.h"
#include "app/preview/scene.h"
#include "core/model/live_distribution.h"
#include "ui/command_search.h"
#include "ui/focus.h"
#include "ui/layers_panel.h"

namespace nacre {

struct DesignerOptions {
    int bake_threads = 0;                                // 0: as many as the machine has
    UserFolders folders = {};                            // without them nothing of the user's is read or kept
    std::optional<DialogProgram> dialogs = {};           // for files; without one Nacre's own browser asks
    std::filesystem::path folder_opener = {};            // see find_folder_opener()
    std::uintmax_t autosave_bytes = autosave_bytes_max;  // at most, of work that is kept
    // A first run begins with the presets, two hints and what an artist calls things; else with all there is.
    bool welcomes = false;
    std::function<void()> wake = {};  // called on a worker's thread when a frame would show something new
};

struct Designer {
    // The worker gives way to drawing by its nice level.
    explicit Designer(const DesignerOptions& options = {});

    DesignerOptions options;
    SettingsFile settings;
    RecentFiles recent;
    Autosave autosave;
    Recovery recovery;
    Document document;
    Scene scene;
    BakeJob baker;
    PreviewPane preview;
    Comparison comparison;
    std::optional<double> other_since;  // when the key went down that shows its other side, while it is held
    CanvasPane canvas;
    FileFlow files;
    FileWatch watch;
    ChangedPictures changed_pictures;
    ImageImport pictures;
    LayerRemake remake;
    StampChooser stamps;
    EnvironmentPanel environment;
    PlotsPane plots;
    ObjectChooser objects;
    ExportFlow exporter;
    ScreenshotSaver pictures_of_preview;
    Thumbnails thumbnails;
    bool panels = true;                                  // shown
    bool history = false;                                // below them, shown with them
    bool full_screen = false;                            // wanted; the host makes it so
    bool sheet = false;                                  // of shortcuts, shown
    bool hints_to_drag = false, hints_to_paint = false;  // until that is done
    std::optional<ui::CommandSearch> search;             // while it is open
    const char* open_tab = nullptr;                      // of the panel, that is to come to the front
    ui::LayersView layers;
    ui::KeyboardFocus focus;
    std::vector<Preset> presets;
    std::optional<std::filesystem::path> pointed_preset;  // in this frame
    std::optional<Trial> trial;                           // of it
    LiveDistribution live;                                // that the frame's p comes from
    Frame frame;                                          // that is on the screen
    double changed_at = 0;  // when p last changed, seconds on Dear ImGui's clock
    std::optional<ui::CanvasTool> tool_before_erase;
    std::pair<std::uint64_t, int> worked_on;  // see Document::identity()
    Design named;                             // as the last frame left it, whose changes have a name
    AtRest rest;                              // what Escape brings back while something is dragged
};

// Draws one frame and acts on its input. Never waits for the worker.
void draw_frame(Designer& designer);

// A file came from outside, by a drop or by the command line: a design is opened, with the question where
// work would be lost; a picture asks what it is for.
void take_file(Designer& designer, const std::filesystem::path& file);

// The design that the program was started with; where it cannot be read, the window says why.
void open_at_start(Designer& designer, const std::filesystem::path& file);

// The window has the focus again: whether another program has changed the files that the work came from is
// looked up, and asked about where one has.
void notice_focus(Designer& designer);

// Whether a dialog has the keyboard.
bool talking(const Designer& designer);

// Whether the next frame will differ without any input or call of `wake`.
bool in_motion(const Designer& designer);

// The clean end, once files.may_quit(): nothing is left to recover.
void finish(Designer& designer);

}  // namespace nacre
