#include "core/base/system/temporary_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/system/system_call.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".nacre-";
constexpr std::size_t random_digits = 16;
constexpr int attempts = 100;

// Modes and groups are no matter of every file system, nor of every user.
bool is_refused(int error) { return error == EPERM || error == ENOSYS || error == EOPNOTSUPP; }

// Who else may do what, or where nobody is named, nobody. Else the bits of the group, which bound what all of
// them may, would be given to the group.
bool take_over_list(const fs::path& from, int to) {
    constexpr const char* name = "system.posix_acl_access";
    const ssize_t size = ::getxattr(from.c_str(), name, nullptr, 0);
    if (size <= 0) {
        const bool has_none = size == 0 || errno == ENODATA || errno == EOPNOTSUPP;
        ::fremovexattr(to, name);
        return has_none;
    }
    std::vector<char> list(static_cast<std::size_t>(size));
    return ::getxattr(from.c_str(), name, list.data(), list.size()) == size &&
           ::fsetxattr(to, name, list.data(), list.size(), 0) == 0;
}

// To lock a file on NFS takes the right to write it.
int open_to_lock(int folder, const char* name) {
    constexpr int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    const int descriptor = ::openat(folder, name, O_RDWR | flags);
    return descriptor >= 0 ? descriptor : ::openat(folder, name, O_RDONLY | flags);
}

// Whoever makes a file locks it next; the one that loses this race takes another name.
void remove_if_left_behind(int folder, const char* name) {
    const Descriptor file(open_to_lock(folder, name));
    struct stat status {};
    if (file.number < 0 || ::fstat(file.number, &status) != 0 || !S_ISREG(status.st_mode)) return;
    if (::flock(file.number, LOCK_EX | LOCK_NB) == 0) ::unlinkat(folder, name, 0);
}

}  // namespace

// .nacre-PROCESS-RANDOM, the second in hexadecimal.
bool is_temporary_name(std::string_view name) {
    if (!name.starts_with(prefix)) return false;
    name.remove_prefix(prefix.size());
    const std::size_t dash = name.find('-');
    if (dash == 0 || dash == std::string_view::npos || name.size() != dash + 1 + random_digits) return false;
    const auto all_of = [](std::string_view text, std::string_view allowed) {
        return text.find_first_not_of(allowed) == std::string_view::npos;
    };
    return all_of(name.substr(0, dash), "0123456789") && all_of(name.substr(dash + 1), "0123456789abcdef");
}

void fail_to_write(const fs::path& file, int error) {
    throw UserError(file.string(), "write", "the file cannot be written", system_reason(error));
}

fs::path temporary_name(const fs::path& folder) {
    std::random_device random;
    const std::uint64_t id = (std::uint64_t{random()} << 32) | random();
    return folder / fmt::format("{}{}-{:0{}x}", prefix, ::getpid(), id, random_digits);
}

void sweep_temporary_files(const fs::path& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.empty() ? "." : folder.c_str()),
                                                      ::closedir);
    if (!entries) return;
    while (const dirent* const entry = ::readdir(entries.get()))
        if (is_temporary_name(entry->d_name)) remove_if_left_behind(::dirfd(entries.get()), entry->d_name);
}

TemporaryFile::TemporaryFile(fs::path file, fs::path target)
    : file_(std::move(file)), target_(std::move(target)) {
    struct stat old {};
    const bool there = ::stat(target_.c_str(), &old) == 0;
    if (!there && errno != ENOENT) fail_to_write(file_, errno);
    replaces_ = there && S_ISREG(old.st_mode);
    for (int attempt = 0; attempt < attempts; ++attempt)
        if (create()) return;
    fail_to_write(file_, EEXIST);
}

TemporaryFile::~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
    if (descriptor_ >= 0) ::close(descriptor_);
}

// Returns whether it is there and locked: somebody who sweeps may have come first.
bool TemporaryFile::create() {
    const fs::path path = temporary_name(target_.parent_path());
    // What replaces a private file is at no time open to others.
    const mode_t mode = replaces_ ? 0600 : 0666;
    descriptor_ =
        uninterrupted([&] { return ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode); });
    if (descriptor_ < 0 && errno == EEXIST) return false;
    if (descriptor_ < 0) fail_to_write(file_, errno);
    path_ = path;
    const bool taken = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    struct stat status {};
    if (!taken && (::fstat(descriptor_, &status) != 0 || status.st_nlink > 0)) return true;
    ::close(std::exchange(descriptor_, -1));
    ::unlink(std::exchange(path_, {}).c_str());
    return false;
}

void TemporaryFile::take_over_access() const {
    struct stat old {
    }, own{};
    if (::stat(target_.c_str(), &old) != 0) {
        if (errno == ENOENT) return;  // it has gone meanwhile
        fail_to_write(file_, errno);
    }
    if (::fstat(descriptor_, &own) != 0) fail_to_write(file_, errno);
    mode_t mode = old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
    const auto give_to = [&](uid_t user) {
        return uninterrupted([&] { return ::fchown(descriptor_, user, old.st_gid); }) == 0;
    };
    const bool same_group = own.st_gid == old.st_gid;
    const bool given = (own.st_uid == old.st_uid && same_group) || give_to(old.st_uid) ||
                       (is_refused(errno) && (same_group || give_to(static_cast<uid_t>(-1))));
    if (!given && !is_refused(errno)) fail_to_write(file_, errno);
    // Another group may do no more than everybody.
    if (!take_over_list(target_, descriptor_) || !given)
        mode = (mode & ~static_cast<mode_t>(S_IRWXG)) | ((mode & S_IRWXO) << 3);
    if (uninterrupted([&] { return ::fchmod(descriptor_, mode); }) != 0 && !is_refused(errno))
        fail_to_write(file_, errno);
}

void TemporaryFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written =
            uninterrupted([&] { return ::write(descriptor_, bytes.data(), bytes.size()); });
        if (written <= 0) fail_to_write(file_, written < 0 ? errno : EIO);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (replaces_) take_over_access();
    // The bytes are on the disk before the name is: a full disk may show only here.
    const bool kept = uninterrupted([&] { return ::fsync(descriptor_); }) == 0;
    if (!kept && errno != EINVAL && errno != ENOSYS) fail_to_write(file_, errno);
}

}  // namespace nacre
