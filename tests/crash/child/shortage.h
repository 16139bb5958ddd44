// The designer where something is short: each way tells on standard output what the window says, a line each.
#pragma once

#include <filesystem>

namespace nacre::test {

// Pictures cannot be read or written: the library for them is missing or damaged.
void without_pictures(const std::filesystem::path& folder);

// There is no memory for the large design `large.nacre` of the folder, and then none for a stroke and an
// export.
void without_memory(const std::filesystem::path& folder);

}  // namespace nacre::test
