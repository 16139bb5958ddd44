#pragma once

#include <filesystem>
#include <string_view>

namespace nacre {

// A file in memory, removed with the object, for libraries that read only files. A UserError of
// `name` where the memory does not suffice.
class MemoryFile {
  public:
    MemoryFile(const char* name, std::string_view bytes);
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile();

    std::filesystem::path path() const;

  private:
    int descriptor_ = -1;
};

}  // namespace nacre
