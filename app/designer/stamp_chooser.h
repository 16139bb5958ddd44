// Asks for a picture to stamp with, and reads it on a worker.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/designer/file_chooser.h"
#include "core/base/latest_job.h"
#include "core/image/picture.h"
#include "ui/hemisphere_canvas.h"

namespace nacre {

class StampChooser {
  public:
    // `wake` is called on the worker's thread when a stamp has been read.
    explicit StampChooser(std::function<void()> wake);

    // Asks where the toolbar wants it, and takes what the worker has read: it becomes the stamp in hand. Once
    // a frame.
    void follow(ui::CanvasState& canvas, const std::optional<DialogProgram>& dialogs);

    // The dialog or the problem, where one is open.
    void talk();
    bool talking() const { return chooser_.open() || !problem_.empty(); }
    const std::string& problem() const { return problem_; }  // shown until it is read
    bool in_motion() const { return chooser_.has_answer(); }

    // A picture that becomes the stamp in hand once it is read.
    void want(std::filesystem::path file);
    void wait() const { job_.wait(); }

    // What is to be said of the picture that was read, once.
    std::optional<std::string> take_note();

  private:
    struct Read {
        NamedStamp stamp;
        PictureNotes notes;
    };
    std::filesystem::path file_;  // wanted last
    FileChooser chooser_;
    std::string problem_;
    std::optional<std::string> note_;
    LatestJob<std::filesystem::path, Read> job_;
};

}  // namespace nacre
