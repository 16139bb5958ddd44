#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "core/base/system/system_call.h"

namespace nacre {

// A file held open for reading, so that what is read is what was looked at. Safe in several threads.
class OpenFile {
  public:
    // A std::system_error where it cannot be opened.
    explicit OpenFile(const std::filesystem::path& file);

    std::uint64_t size() const { return size_; }
    // As many of the bytes as can be read.
    std::size_t read(std::uint64_t offset, void* to, std::size_t length) const;
    // The name that opens what is held, whatever has become of its own.
    std::filesystem::path path() const;

  private:
    Descriptor descriptor_;
    std::uint64_t size_ = 0;
};

}  // namespace nacre
