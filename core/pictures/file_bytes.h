// A picture's file as its decoder sees it.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/system/open_file.h"

namespace nacre {

// An open file, read a window at a time. Safe in several threads.
class FileBytes {
  public:
    // A PictureProblem where the file cannot be read or has more bytes than `most`.
    FileBytes(const std::filesystem::path& file, std::uintmax_t most);

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path held_path() const { return file_->path(); }  // for a decoder that opens it itself
    std::uint64_t size() const { return file_->size(); }
    // As many of the bytes as can be read: decoders in C call this, so it throws nothing.
    std::size_t read(std::uint64_t offset, void* to, std::size_t length) const;
    std::string read(std::uint64_t offset, std::uint64_t length) const;

  private:
    std::filesystem::path path_;
    std::optional<OpenFile> file_;
    // Decoders read a few bytes at a time: those around the last ones.
    mutable std::mutex mutex_;
    mutable std::string window_;
    mutable std::uint64_t window_start_ = 0;
};

// Some of what a decoder sees: a range of the file, or `bytes` in place of one.
struct Piece {
    std::string bytes;
    std::uint64_t offset = 0, length = 0;  // without `bytes`
};

// Pieces one after the other.
class PieceProxy : public OIIO::Filesystem::IOProxy {
  public:
    PieceProxy(const FileBytes& file, std::vector<Piece> pieces);
    const char* proxytype() const override { return "pieces"; }
    std::size_t size() const override { return size_; }
    std::size_t read(void* to, std::size_t length) override;
    std::size_t pread(void* to, std::size_t length, std::int64_t offset) override;

  private:
    const FileBytes& file_;
    std::vector<Piece> pieces_;
    std::vector<std::uint64_t> starts_;
    std::size_t size_ = 0;
};

}  // namespace nacre
