// A folder that files are written into.
#pragma once

#include <filesystem>
#include <vector>

namespace nacre {

// Created with its parents where missing; a UserError on failure. The destructor
// removes what was created if it is still empty.
class OutputFolder {
  public:
    explicit OutputFolder(const std::filesystem::path& folder);
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder();

  private:
    void remove_empty() const;

    std::vector<std::filesystem::path> made_;  // innermost first
};

}  // namespace nacre
