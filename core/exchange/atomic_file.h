// Files that appear whole or not at all: written beside their target under another name, handed to the disk,
// then renamed. Neither a program that is killed nor a machine that stops leaves half a file under the name.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace nacre {

// The file that a name stands for, there or not: the end of a chain of symbolic links.
std::filesystem::path link_target(const std::filesystem::path& file);

// A target that exists keeps its permissions; a symbolic link's target is replaced, not the link.
// Whatever fails is a UserError about `file`, with the system's reason, and leaves no temporary file.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

// `write` fills the temporary path it is given, an empty file with the target's extension. What it
// throws passes through, and the target stays as it was.
void write_file_atomically(const std::filesystem::path& file,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

// As above, under the first free name of STEM-001EXTENSION, STEM-002EXTENSION, ... in the folder; never in
// place of a file that is there. Returns the name taken.
std::filesystem::path write_numbered_file(
    const std::filesystem::path& folder, const std::string& stem, const std::string& extension,
    const std::function<void(const std::filesystem::path& temporary)>& write);

// Renames unless `to` exists or the system refuses; both lie on one file system. Returns whether it did.
bool rename_if_free(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace nacre
