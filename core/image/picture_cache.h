// A cache of decoded pictures, by their files' content and their use.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/system/file_content.h"
#include "core/image/picture.h"

namespace nacre {

// Nothing where the file cannot be read, or is larger than any picture may be.
std::optional<FileContent> picture_file_content(const std::filesystem::path& file);

// The most recently used ones, up to 64 MiB. Thread-safe.
struct KeptPicture {
    std::shared_ptr<const void> picture;
    PictureNotes notes;
};
std::optional<KeptPicture> kept_picture(const FileContent& content, const std::string& use);
void keep_picture(const FileContent& content, const std::string& use, KeptPicture picture, std::size_t bytes);

// The result of `load` for the file and use, or a cached one for the same content.
template <class Picture, class Load, class Bytes>
std::shared_ptr<const Picture> decoded_once(const std::filesystem::path& file, const std::string& use,
                                            PictureNotes* notes, const Load& load, const Bytes& bytes_of) {
    const auto content = picture_file_content(file);
    KeptPicture kept;
    if (auto found = content ? kept_picture(*content, use) : std::nullopt) {
        kept = *std::move(found);
    } else {
        kept.picture = std::make_shared<const Picture>(load(kept.notes));
        const auto picture = std::static_pointer_cast<const Picture>(kept.picture);
        // Not cached if the file changed meanwhile.
        if (content && picture_file_content(file) == content)
            keep_picture(*content, use, kept, bytes_of(*picture));
    }
    if (notes != nullptr) *notes = kept.notes;
    return std::static_pointer_cast<const Picture>(kept.picture);
}

}  // namespace nacre
