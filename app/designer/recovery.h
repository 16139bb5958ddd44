// Work that a process left behind when it was killed: found at the start, offered, restored or discarded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/designer/autosave.h"
#include "core/base/system/locked_directory.h"

namespace nacre {

struct LostWork {
    LockedDirectory folder;
    std::string name;            // of the design
    std::filesystem::path file;  // of the document, or empty
    std::string when;            // of its last change, local time
    std::string problem;         // why it cannot be read, or empty
};

class Recovery {
  public:
    explicit Recovery(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Looks for what dead processes left, and offers it if there is any. Folders without work are removed.
    void look();

    // Draws the offer while it stands; returns the work to go on with.
    std::optional<RecoveredWork> draw();

    bool talking() const { return !lost_.empty(); }
    std::size_t count() const { return lost_.size(); }

  private:
    std::filesystem::path folder_;
    std::vector<LostWork> lost_;  // newest first
    std::size_t chosen_ = 0;
    std::string problem_;
};

// The document whose file holds this very work, if it does.
std::optional<Document> saved_already(const UnsavedWork& work);

}  // namespace nacre
