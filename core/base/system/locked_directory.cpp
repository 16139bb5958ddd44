#include "core/base/system/locked_directory.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/system/private_folder.h"
#include "core/base/system/temporary_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "lock";

[[noreturn]] void fail(const fs::path& path, int error) {
    throw UserError(path.string(), "write", "unsaved work cannot be kept there",
                    std::generic_category().message(error));
}

// "4711-0123abcd"
bool is_owners_name(std::string_view name) {
    const auto dash = name.find('-');
    if (dash == 0 || dash == name.npos || name.size() - dash != 9) return false;
    return name.substr(0, dash).find_first_not_of("0123456789") == name.npos &&
           name.substr(dash + 1).find_first_not_of("0123456789abcdef") == name.npos;
}

// The entry itself, where it is a link too.
std::optional<struct stat> entry(int folder, const char* name) {
    struct stat status {};
    if (::fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) != 0) return {};
    return status;
}

bool same_file(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool is_regular(int folder, const char* name) {
    const auto status = entry(folder, name);
    return status && S_ISREG(status->st_mode);
}

// What a lock is: an empty file.
bool is_lock(const struct stat& status) { return S_ISREG(status.st_mode) && status.st_size == 0; }

struct Contents {
    bool work = false, foreign = false;
    std::vector<std::string> temporary;
};

Contents contents_of(const fs::path& folder) {
    Contents contents;
    std::error_code error;
    for (auto it = fs::directory_iterator(folder, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        const std::string name = it->path().filename().string();
        std::error_code unreadable;
        const bool regular = fs::is_regular_file(it->symlink_status(unreadable));
        if (regular && name == autosave_name)
            contents.work = true;
        else if (regular && is_temporary_name(name))
            contents.temporary.push_back(name);
        else if (!regular || name != lock_name)
            contents.foreign = true;
    }
    contents.foreign = contents.foreign || error;
    return contents;
}

}  // namespace

std::optional<LockedDirectory> LockedDirectory::own(const fs::path& folder) {
    const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (opened < 0) return {};
    LockedDirectory owned(folder, opened, -1);
    owned.lock_ = ::openat(opened, lock_name, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600);
    struct stat now {};
    // Who held it before may have erased the folder between the two calls.
    if (owned.lock_ < 0 || ::flock(owned.lock_, LOCK_EX | LOCK_NB) != 0 || ::fstat(owned.lock_, &now) != 0 ||
        now.st_nlink == 0 || !is_lock(now))
        return {};
    return owned;
}

LockedDirectory::LockedDirectory(LockedDirectory&& other) noexcept
    : path_(std::move(other.path_)),
      folder_(std::exchange(other.folder_, -1)),
      lock_(std::exchange(other.lock_, -1)) {}

LockedDirectory& LockedDirectory::operator=(LockedDirectory&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(folder_, other.folder_);
    std::swap(lock_, other.lock_);
    return *this;
}

LockedDirectory::~LockedDirectory() {
    const int error = errno;  // of what was tried with it
    if (lock_ >= 0) ::close(lock_);
    if (folder_ >= 0) ::close(folder_);
    errno = error;
}

bool LockedDirectory::intact() const {
    struct stat here {
    }, folder{}, held{};
    if (::lstat(path_.c_str(), &here) != 0 || ::fstat(folder_, &folder) != 0 || !same_file(here, folder))
        return false;
    const auto lock = entry(folder_, lock_name), file = entry(folder_, autosave_name);
    if (!lock || ::fstat(lock_, &held) != 0 || !same_file(*lock, held)) return false;
    return !file || S_ISREG(file->st_mode);
}

void LockedDirectory::take(const LockedDirectory& from) {
    if (!from.intact() || !intact()) fail(from.file(), EPERM);
    if (::renameat(from.folder_, autosave_name, folder_, autosave_name) != 0) fail(from.file(), errno);
}

void LockedDirectory::remove_file() {
    if (!entry(folder_, autosave_name)) return;
    if (!is_regular(folder_, autosave_name)) fail(file(), EPERM);
    if (::unlinkat(folder_, autosave_name, 0) != 0 && errno != ENOENT) fail(file(), errno);
}

void LockedDirectory::erase() {
    if (!intact()) return;
    ::unlinkat(folder_, autosave_name, 0);
    for (const std::string& name : contents_of(path_).temporary) ::unlinkat(folder_, name.c_str(), 0);
    ::unlinkat(folder_, lock_name, 0);
    ::rmdir(path_.c_str());
}

LockedDirectory make_locked_directory(const fs::path& parent) {
    make_private_folder(parent);
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
        const fs::path path = parent / fmt::format("{}-{:08x}", ::getpid(), random());
        if (::mkdir(path.c_str(), 0700) != 0) {
            if (errno == EEXIST) continue;
            fail(path, errno);
        }
        if (auto owned = LockedDirectory::own(path)) return std::move(*owned);
        // Another process took it for an orphan before it had a lock, or there can be no lock at all.
        if (errno != EWOULDBLOCK && errno != ENOENT) fail(path, errno);
    }
    fail(parent, EBUSY);
}

std::vector<LockedDirectory> claim_abandoned(const fs::path& parent) {
    std::vector<LockedDirectory> orphans;
    std::error_code error;
    for (auto it = fs::directory_iterator(parent, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        std::error_code unreadable;
        if (!is_owners_name(it->path().filename().string())) continue;
        if (!fs::is_directory(it->symlink_status(unreadable))) continue;
        const Contents contents = contents_of(it->path());
        if (contents.foreign && !contents.work) continue;
        if (auto owned = LockedDirectory::own(it->path())) orphans.push_back(std::move(*owned));
    }
    return orphans;
}

}  // namespace nacre
