// The row of objects above the preview, and the file that one can come from.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/designer/file_chooser.h"
#include "app/designer/object_shelf.h"
#include "app/preview/scene.h"

namespace nacre {

class ObjectChooser {
  public:
    // The object appears when it is made, seen as it is usually or, where the camera is kept, from there.
    void want(const std::string& name, bool keep_camera = false) {
        keep_camera_ = keep_camera;
        shelf_.want(name);
    }

    // The row, in the current Dear ImGui window. Takes what has been made into the scene. `dialogs` asks for
    // a file where one is wanted.
    void draw(Scene& scene, const std::optional<DialogProgram>& dialogs);

    // What of the file just shown was left out or made up, once.
    std::optional<std::string> take_note() { return std::exchange(note_, std::nullopt); }

    // The dialog or the problem, where one is open.
    void talk();
    bool talking() const { return chooser_.open() || !problem().empty(); }
    const std::string& problem() const { return shelf_.problem(); }  // shown until it is read

    bool in_motion() const { return shelf_.busy() || chooser_.has_answer(); }
    void wait() const { shelf_.wait(); }

    // As of ObjectShelf.
    HeldFiles& held() { return shelf_.held(); }
    const HeldFiles& held() const { return shelf_.held(); }

  private:
    void buttons(const std::string& file_label, bool own, const std::optional<DialogProgram>& dialogs);
    void list(const std::string& file_label, bool own, const std::optional<DialogProgram>& dialogs);
    void ask_file(const std::optional<DialogProgram>& dialogs);

    bool keep_camera_ = false;
    ObjectShelf shelf_;
    FileChooser chooser_;
    std::filesystem::path last_folder_;
    std::optional<std::string> note_;
};

}  // namespace nacre
