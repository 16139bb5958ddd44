#pragma once

#include <filesystem>

namespace nacre {

// Creates the folder with its parents, accessible to its user alone; an existing one stays as it is.
// A UserError on failure.
void make_private_folder(const std::filesystem::path& folder);

}  // namespace nacre
