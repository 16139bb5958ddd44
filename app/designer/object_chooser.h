// The row of objects above the preview, and the file that one can come from.
#pragma once

#include <optional>

#include "app/designer/object_shelf.h"
#include "app/preview/scene.h"
#include "ui/dialogs.h"

namespace nacre {

class ObjectChooser {
  public:
    // The object appears when it is made, as seen first.
    void want(const std::string& name) { shelf_.want(name); }

    // The row, in the current Dear ImGui window. Takes what has been made into the scene.
    void draw(Scene& scene);

    // The dialog and the problem, where one is open.
    void talk();
    bool talking() const { return dialog_ || !shelf_.problem().empty(); }

    bool busy() const { return shelf_.busy(); }
    void wait() const { shelf_.wait(); }

  private:
    ObjectShelf shelf_;
    std::optional<ui::FileDialog> dialog_;
    std::filesystem::path last_folder_;
};

}  // namespace nacre
