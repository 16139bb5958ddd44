// A folder that belongs to one process for as long as it lives, however it ends.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nacre {

// Holds a lock (flock) on a file in the folder, which the system frees when the process is gone.
class OwnedFolder {
  public:
    // The folder's owner from now on, unless somebody else is it.
    static std::optional<OwnedFolder> own(const std::filesystem::path& folder);

    OwnedFolder(OwnedFolder&& other) noexcept;
    OwnedFolder& operator=(OwnedFolder&& other) noexcept;
    ~OwnedFolder();  // gives it up and leaves what it holds

    const std::filesystem::path& path() const { return path_; }

    // A file of the same name in the other folder becomes one of this, in place of what was there. What fails
    // is a UserError.
    void take(const std::string& name, const OwnedFolder& from);
    void remove(const std::string& name);

    // The folder goes, with all that it holds.
    void erase();

  private:
    OwnedFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

    std::filesystem::path path_;
    int lock_;  // descriptor
};

// A new folder below `parent`, which is made when it is not there, named by the process and a random number.
// What fails is a UserError.
OwnedFolder make_owned_folder(const std::filesystem::path& parent);

// The folders below `parent` whose owners are gone: this process is their owner now.
std::vector<OwnedFolder> own_orphans(const std::filesystem::path& parent);

}  // namespace nacre
