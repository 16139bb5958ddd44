// Files that appear whole or not at all: written beside their target under another name, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace nacre {

// A target that exists keeps its permissions; a symbolic link's target is replaced, not the link.
// Whatever fails is a UserError about `file`, with the system's reason, and leaves no temporary file.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

// `write` fills the temporary path it is given, an empty file with the target's extension. What it
// throws passes through, and the target stays as it was.
void write_file_atomically(const std::filesystem::path& file,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

}  // namespace nacre
