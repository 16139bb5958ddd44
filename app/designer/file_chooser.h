// Asks for a file or a folder: in the desktop's own dialog where there is one, else in Nacre's browser.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/designer/system_dialog.h"
#include "ui/dialogs.h"

namespace nacre {

class FileChooser {
  public:
    // One question at a time, from the nearest folder that exists. Without a program, or where it fails, the
    // browser asks.
    void ask(FileQuestion question, const std::optional<DialogProgram>& program);

    struct Answer {
        // Empty: cancelled. To save under, with the first extension of the question where it had none of
        // them.
        std::filesystem::path chosen;
    };
    // Draws what is open. The answer comes once.
    std::optional<Answer> draw();

    bool open() const { return system_ || browser_; }
    // Whether the desktop's dialog has an answer that the next draw() hands out.
    bool has_answer() const;

  private:
    ui::Listing list(const std::filesystem::path& folder) const;
    void browse();
    Answer chosen(std::filesystem::path file) const;
    std::optional<Answer> draw_system();

    FileQuestion question_;
    std::unique_ptr<SystemDialog> system_;
    std::optional<ui::FileDialog> browser_;
};

}  // namespace nacre
