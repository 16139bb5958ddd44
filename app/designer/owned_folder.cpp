#include "app/designer/owned_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

#include "app/designer/kept_file.h"
#include "core/design/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "lock";

[[noreturn]] void fail(const fs::path& path, int error) {
    throw UserError(path.string(), "write", "unsaved work cannot be kept there",
                    std::generic_category().message(error));
}

}  // namespace

std::optional<OwnedFolder> OwnedFolder::own(const fs::path& folder) {
    const fs::path file = folder / lock_name;
    const int lock = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock < 0) return {};
    OwnedFolder owned(folder, lock);
    struct stat now {};
    // Who held it before may have erased the folder between the two calls.
    if (::flock(lock, LOCK_EX | LOCK_NB) != 0 || ::fstat(lock, &now) != 0 || now.st_nlink == 0) return {};
    return owned;
}

OwnedFolder::OwnedFolder(OwnedFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

OwnedFolder& OwnedFolder::operator=(OwnedFolder&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(lock_, other.lock_);
    return *this;
}

OwnedFolder::~OwnedFolder() {
    if (lock_ >= 0) ::close(lock_);
}

void OwnedFolder::take(const std::string& name, const OwnedFolder& from) {
    if (::rename((from.path_ / name).c_str(), (path_ / name).c_str()) != 0) fail(from.path_ / name, errno);
}

void OwnedFolder::remove(const std::string& name) {
    const fs::path file = path_ / name;
    if (::unlink(file.c_str()) != 0 && errno != ENOENT) fail(file, errno);
}

void OwnedFolder::erase() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

OwnedFolder make_owned_folder(const fs::path& parent) {
    make_private_folder(parent);
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
        const fs::path path = parent / fmt::format("{}-{:08x}", ::getpid(), random());
        if (::mkdir(path.c_str(), 0700) != 0) {
            if (errno == EEXIST) continue;
            fail(path, errno);
        }
        if (auto owned = OwnedFolder::own(path)) return std::move(*owned);
        // Another process took it for an orphan before it had a lock, or there can be no lock at all.
        if (errno != EWOULDBLOCK && errno != ENOENT) fail(path, errno);
    }
    fail(parent, EBUSY);
}

std::vector<OwnedFolder> own_orphans(const fs::path& parent) {
    std::vector<OwnedFolder> orphans;
    std::error_code error;
    for (auto it = fs::directory_iterator(parent, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        std::error_code unreadable;
        if (!it->is_directory(unreadable) || unreadable) continue;
        if (auto owned = OwnedFolder::own(it->path())) orphans.push_back(std::move(*owned));
    }
    return orphans;
}

}  // namespace nacre
