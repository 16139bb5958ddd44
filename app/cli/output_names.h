// Names for several outputs in one folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nacre::cli {

// As many names as stems, no two of them one file in `folder` and none of them one of `taken`. A stem that
// comes first, or alone, is its own name; the others get the first free of STEM-2, STEM-3, ...
std::vector<std::string> distinct_names(const std::vector<std::string>& stems,
                                        const std::vector<std::string>& taken,
                                        const std::filesystem::path& folder);

}  // namespace nacre::cli
