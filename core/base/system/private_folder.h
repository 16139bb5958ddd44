#pragma once

#include <filesystem>

namespace nacre {

// Makes the folder, with those it lies in, for its user alone; one that is there stays as it is. What fails
// is a UserError.
void make_private_folder(const std::filesystem::path& folder);

}  // namespace nacre
