// The question about files that the work refers to and that are not as they were when they were read: the
// design's pictures, the environment map, the object. One question names all of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/designer/document.h"
#include "app/designer/environment_panel.h"
#include "app/designer/file_watch.h"
#include "app/designer/object_chooser.h"

namespace nacre {

class ChangedPictures {
  public:
    void notice(std::vector<FileChange> changes) { changes_ = std::move(changes); }

    // Draws the question and acts on the answer. Returns what is to be told.
    std::optional<std::string> draw(Document& document, EnvironmentPanel& environment,
                                    ObjectChooser& objects);

    bool talking() const { return !changes_.empty() || !problem_.empty(); }
    const std::string& problem() const { return problem_; }  // shown until it is read

  private:
    std::vector<FileChange> take(bool gone);

    std::vector<FileChange> changes_;
    std::string problem_;
};

}  // namespace nacre
