// The designer on a window that nobody sees: an OSMesa context, scripted input and a clock of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "app/designer/designer.h"
#include "app/designer/imgui_session.h"
#include "app/headless/event_script.h"
#include "app/headless/offscreen_context.h"
#include "ui/item_map.h"

namespace nacre {

struct StageOptions {
    glm::ivec2 size{1280, 800};  // pixels
    float ui_scale = 1;
    float pixels_a_unit = 1;   // of the interface: more on screens whose units are not their pixels
    int bake_threads = 0;      // as many as the machine has
    UserFolders folders = {};  // a test's own; without them nothing of the user's is read or kept
    std::optional<DialogProgram> dialogs = {};
    std::filesystem::path folder_opener = {};
    std::uintmax_t autosave_bytes = autosave_bytes_max;
    bool welcomes = false;  // as the window does at a first run
};

class HeadlessDesigner {
  public:
    explicit HeadlessDesigner(const StageOptions& options);

    Designer& designer() { return *designer_; }
    const ui::ItemMap& items() const { return items_; }

    // As if the window came to another monitor.
    void set_scale(float ui_scale, float pixels_a_unit = 1) { session_.set_scale(ui_scale, pixels_a_unit); }

    // One frame of a sixtieth of a second with the present input; `rasterise` false leaves out the
    // last step, the drawing of the interface's triangles.
    void frame(bool rasterise = true);

    // Each event is followed by the frames it needs. An unknown widget is a UserError at its line.
    void play(const EventScript& script);

    // Until the worker is idle and its tables are on the screen.
    void wait_for_bake();

    // Of the last rasterised frame: rows from the top, four bytes a pixel.
    std::vector<std::uint8_t> pixels() const;
    glm::ivec2 size() const { return size_; }

  private:
    void play(const Event& event, const std::string& file);
    glm::vec2 pixel_of(const Place& place, const std::string& file, int line);
    void move_to(glm::vec2 pixel);
    void press(int button, bool down);

    glm::ivec2 size_;
    std::unique_ptr<OffscreenContext> context_;
    ImguiSession session_;
    ui::ItemMap items_;
    std::unique_ptr<Designer> designer_;
};

}  // namespace nacre
