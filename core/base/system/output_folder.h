// A folder that files are written into.
#pragma once

#include <filesystem>
#include <vector>

namespace nacre {

// Made, with those it lies in, where it is not there; a UserError where it cannot be. What was made goes
// again with the object, unless something has been written there.
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
