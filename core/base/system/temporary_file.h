// A temporary file that becomes a file's new content.
#pragma once

#include <filesystem>
#include <string_view>

namespace nacre {

// Written beside its target under a name of its own, and removed unless it has become the target. It is
// locked as long as its process lives, so that others know whether it was left behind. What fails is a
// UserError about `file`, the name that the user knows, with the system's reason.
class TemporaryFile {
  public:
    TemporaryFile(std::filesystem::path file, std::filesystem::path target);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    // All of it, and on the disk when it returns. It then has the mode, group and access control list of the
    // target that is there, without the bits that would let it run as somebody else.
    void write(std::string_view bytes);

    const std::filesystem::path& file() const { return file_; }
    const std::filesystem::path& target() const { return target_; }
    const std::filesystem::path& path() const { return path_; }

    // It has been renamed, so there is nothing to remove.
    void release() { path_.clear(); }

  private:
    bool create();
    void take_over_access() const;

    std::filesystem::path file_, target_, path_;
    int descriptor_ = -1;
    bool replaces_ = false;
};

// A name for a temporary file of this process in `folder`.
std::filesystem::path temporary_name(const std::filesystem::path& folder);

// Whether the name is that of such a file.
bool is_temporary_name(std::string_view name);

// Removes the temporary files there whose processes have ended. Of other files none, and none of a file
// system that knows no locks.
void sweep_temporary_files(const std::filesystem::path& folder);

// As a UserError about `file`, which cannot be written.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error);

}  // namespace nacre
