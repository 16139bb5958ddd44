#include "app/designer/stamp_chooser.h"

#include <memory>
#include <utility>

#include "app/designer/picture_notes.h"
#include "app/designer/picture_trouble.h"

namespace nacre {

StampChooser::StampChooser(std::function<void()> wake)
    : job_(
          [](const std::filesystem::path& file, const std::stop_token&, const auto& publish) {
              PictureNotes notes;
              auto picture = std::make_shared<const Raster>(load_stamp(file, &notes));
              publish({named_stamp(file.stem().string(), std::move(picture)), std::move(notes)});
          },
          std::move(wake)) {}

void StampChooser::want(std::filesystem::path file) {
    file_ = std::move(file);
    job_.submit(file_);
}

void StampChooser::follow(ui::CanvasState& canvas, const std::optional<DialogProgram>& dialogs) {
    if (std::exchange(canvas.asks_for_stamp, false)) {
        std::vector<std::string> extensions = picture_extensions();
        extensions.emplace_back(".svg");
        chooser_.ask({.purpose = ui::FileDialog::Purpose::open,
                      .title = "Load a stamp",
                      .folder = file_.parent_path(),
                      .kind = "Picture",
                      .extensions = std::move(extensions)},
                     dialogs);
    }
    auto read = job_.poll();
    if (!read) return;
    if (read->error) {
        problem_ = picture_trouble(file_, read->error);
        return;
    }
    canvas.stamps.push_back(std::move(read->result->stamp));
    canvas.stamp = canvas.stamps.size() - 1;
    canvas.tool = ui::CanvasTool::stamp;
    if (!read->result->notes.empty()) note_ = notes_line(file_, read->result->notes);
}

void StampChooser::talk() {
    if (!problem_.empty()) {
        if (ui::question("Cannot load the stamp", problem_, {"OK"})) problem_.clear();
        return;
    }
    const auto answer = chooser_.draw();
    if (answer && !answer->chosen.empty()) want(answer->chosen);
}

std::optional<std::string> StampChooser::take_note() { return std::exchange(note_, std::nullopt); }

}  // namespace nacre
