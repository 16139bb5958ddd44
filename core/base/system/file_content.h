// The content of a file as size and digest: finds a change even where the file's times do not show it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace nacre {

struct FileContent {
    std::uint64_t bytes = 0;
    std::uint64_t digest = 0;
    bool operator==(const FileContent&) const = default;
};

FileContent content_of(std::string_view bytes);

// Nothing unless it is a regular file that can be read.
std::optional<FileContent> content_of_file(const std::filesystem::path& file);

// "4096-00ff...": the text reads back as the same content; nothing for any other text.
std::string content_text(const FileContent& content);
std::optional<FileContent> parse_content(std::string_view text);

// What files held when they were last read or written. A file that is not in it was not there.
using HeldFiles = std::map<std::filesystem::path, FileContent>;

std::optional<FileContent> content_in(const HeldFiles& held, const std::filesystem::path& file);

// What these hold now.
template <class Files>
HeldFiles held_now(const Files& files) {
    HeldFiles held;
    for (const std::filesystem::path& file : files)
        if (const auto content = content_of_file(file)) held[file] = *content;
    return held;
}

}  // namespace nacre
