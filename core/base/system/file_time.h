#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace nacre {

// When the file was last written, nanoseconds since 1970; nothing for anything but a regular file, a link to
// one included.
std::optional<std::int64_t> time_written(const std::filesystem::path& file);

// "2026-11-29 11:37:33", where the machine is.
std::string local_time(std::int64_t nanoseconds);

}  // namespace nacre
