// Files that appear whole or not at all: written beside their target under another name, handed to the disk,
// then renamed. Neither a program that is killed nor a machine that stops leaves half a file under the name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

// The file that a name refers to, existing or not: the end of a chain of symbolic
// links. A UserError on failure.
std::filesystem::path link_target(const std::filesystem::path& file);

// A target that exists keeps its permissions; a symbolic link's target is replaced, not the link.
// Whatever fails is a UserError about `file`, with the system's reason, and leaves the old file as it was and
// no temporary file. Those of programs that were killed are removed from the folder.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

struct FileToWrite {
    std::filesystem::path file;
    std::string_view bytes;
};

// Files that belong together, the last describing the others. All are on the disk before the first gets its
// name; an error leaves the old ones. The old last file goes before any other is replaced, and the new one
// comes after all: even when the program is killed it is never beside files that it does not describe.
void write_files_atomically(const std::vector<FileToWrite>& files);

// As one file, under the first free name of STEM-001EXTENSION, STEM-002EXTENSION, ... in the folder; never in
// place of a file that is there. Returns the name taken.
std::filesystem::path write_numbered_file(const std::filesystem::path& folder, const std::string& stem,
                                          const std::string& extension, std::string_view bytes);

// Renames unless `to` exists or the system refuses; both lie on one file system. Returns whether it did.
bool rename_if_free(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace nacre
