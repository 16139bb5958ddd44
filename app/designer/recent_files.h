// The designs that were opened and saved last, newest first.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/designer/private_json_file.h"

namespace nacre {

// The paths that recent.json holds. What is wrong with the text is a UserError of `name`.
std::vector<std::filesystem::path> parse_recent(const std::string& text, const std::string& name);

class RecentFiles {
  public:
    static constexpr std::size_t files_max = 12;

    // Reads recent.json of the folder, if it is there. An empty folder: they last as long as this value.
    explicit RecentFiles(const std::filesystem::path& folder);

    const std::vector<std::filesystem::path>& files() const { return files_; }

    // Puts a file first. What other windows noted meanwhile stays.
    void note(const std::filesystem::path& file);
    void forget(const std::filesystem::path& file);
    void clear();

    const std::string& problem() const { return file_.problem(); }

  private:
    void read();
    void write();

    PrivateJsonFile file_;
    std::vector<std::filesystem::path> files_;
};

}  // namespace nacre
