// F12: the preview as a PNG file in a chosen folder, under the next free number.
#pragma once

#include <optional>
#include <string>

#include "app/designer/background_task.h"
#include "app/designer/document.h"
#include "app/designer/file_chooser.h"
#include "app/designer/preview_pane.h"
#include "app/designer/settings.h"

namespace nacre {

class ScreenshotSaver {
  public:
    // The first time asks for the folder.
    void take() { wanted_ = true; }
    void choose_folder() { asking_ = true; }

    void remember(Settings* settings, const std::optional<DialogProgram>& dialogs) {
        settings_ = settings;
        dialogs_ = dialogs;
    }

    // Goes on with what was begun. Returns what is to be told of it.
    std::optional<std::string> draw(const Document& document, PreviewPane& preview, const Scene& scene);

    bool talking() const { return asking_ || chooser_.open() || !problem_.empty(); }
    const std::string& problem() const { return problem_; }  // shown until it is read
    bool in_motion() const { return wanted_ || task_.busy() || chooser_.has_answer(); }

  private:
    void ask(const Document& document);
    void begin(const Document& document, PreviewPane& preview, const Scene& scene);

    Settings* settings_ = nullptr;
    std::optional<DialogProgram> dialogs_;
    bool wanted_ = false, asking_ = false;
    FileChooser chooser_;
    BackgroundTask task_;
    std::string problem_;
};

}  // namespace nacre
