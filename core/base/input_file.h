// Files that are read: only regular files of a bounded size, so that no device or pipe can hang a
// program and no file can exhaust its memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/limits.h"

namespace nacre {

// Why `file` cannot be read, or an empty text.
std::string input_file_problem(const std::filesystem::path& file,
                               std::uintmax_t bytes_max = limits::file_bytes_max);

// The whole file. What is wrong is a UserError about `file`, at `open` or `read`.
std::string read_text_file(const std::filesystem::path& file,
                           std::uintmax_t bytes_max = limits::file_bytes_max);

// The text without a UTF-8 byte order mark.
std::string_view without_byte_order_mark(std::string_view text);

// The first line without its line end; the same errors. A file without a line end is one line.
std::string read_first_line(const std::filesystem::path& file,
                            std::uintmax_t bytes_max = limits::file_bytes_max);

// The folder with symbolic links resolved, the current one when empty: `..` in a path relative to it
// then means what it means to the system.
std::filesystem::path absolute_folder(const std::filesystem::path& folder);

}  // namespace nacre
