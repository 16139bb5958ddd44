// A folder that belongs to one process while that lives, however it ends.
// Files that this program did not write are neither followed nor removed.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace nacre {

inline constexpr const char* autosave_name = "unsaved.nacre";  // the one file that it keeps

// Holds a lock (flock) on a file in the folder, which the system frees when the process is gone.
class LockedDirectory {
  public:
    // Takes ownership of the folder, unless another process has it or its lock is not one of ours.
    static std::optional<LockedDirectory> own(const std::filesystem::path& folder);

    LockedDirectory(LockedDirectory&& other) noexcept;
    LockedDirectory& operator=(LockedDirectory&& other) noexcept;
    ~LockedDirectory();  // gives it up and leaves what it holds

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path file() const { return path_ / autosave_name; }

    // Whether the path still leads to this folder and its lock, and the kept file is one or is not there:
    // what is written then changes nothing else.
    bool intact() const;

    // The kept file of the other folder becomes this one's. What fails is a UserError.
    void take(const LockedDirectory& from);
    void remove_file();

    // The kept file and the lock go, and the folder unless it holds anything else.
    void erase();

  private:
    LockedDirectory(std::filesystem::path path, int folder, int lock)
        : path_(std::move(path)), folder_(folder), lock_(lock) {}

    std::filesystem::path path_;
    int folder_, lock_;  // descriptors
};

// A new folder below `parent`, which is made when it is not there, named by the process and a random number.
// What fails is a UserError.
LockedDirectory make_locked_directory(const std::filesystem::path& parent);

// The folders of that form below `parent` whose owners are gone and that hold a kept file, or nothing but
// what an owner leaves: this process is their owner now.
std::vector<LockedDirectory> claim_abandoned(const std::filesystem::path& parent);

}  // namespace nacre
