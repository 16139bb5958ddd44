// Pictures that were decoded, by their files' content and what was made of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/image/picture.h"

namespace nacre {

// What tells one file from another, wherever they are.
struct FileContent {
    std::uint64_t size = 0, hash = 0;
    bool operator==(const FileContent&) const = default;
};

// Nothing where the file cannot be read.
std::optional<FileContent> content_of(const std::filesystem::path& file);

// The last ones, of 64 MiB together. Safe in several threads.
struct KeptPicture {
    std::shared_ptr<const void> picture;
    PictureNotes notes;
};
std::optional<KeptPicture> kept_picture(const FileContent& content, const std::string& use);
void keep_picture(const FileContent& content, const std::string& use, KeptPicture picture, std::size_t bytes);

// What `load` makes of the file for a use, or has made of one with the same content.
template <class Picture, class Load, class Bytes>
std::shared_ptr<const Picture> decoded_once(const std::filesystem::path& file, const std::string& use,
                                            PictureNotes* notes, const Load& load, const Bytes& bytes_of) {
    const auto content = content_of(file);
    KeptPicture kept;
    if (auto found = content ? kept_picture(*content, use) : std::nullopt) {
        kept = *std::move(found);
    } else {
        kept.picture = std::make_shared<const Picture>(load(kept.notes));
        const auto picture = std::static_pointer_cast<const Picture>(kept.picture);
        // What changed meanwhile is of no known content.
        if (content && content_of(file) == content) keep_picture(*content, use, kept, bytes_of(*picture));
    }
    if (notes != nullptr) *notes = kept.notes;
    return std::static_pointer_cast<const Picture>(kept.picture);
}

}  // namespace nacre
