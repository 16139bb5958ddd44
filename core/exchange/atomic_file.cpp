#include "core/exchange/atomic_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include "core/design/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int numbers_most = 99'999;
constexpr int links_most = 40;  // as many as Linux follows

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw UserError(file.string(), "write", "the file cannot be written", reason);
}

std::string system_reason(int error) { return std::generic_category().message(error); }

// Where the bytes go. Devices and pipes are refused, since a rename would replace the device itself.
fs::path final_target(const fs::path& file) {
    std::error_code error;
    const fs::path target = link_target(file);
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status) || !target.has_filename()) fail(file, "it is a directory");
    if (fs::is_symlink(fs::symlink_status(target, error))) fail(file, system_reason(ELOOP));
    if (!fs::exists(status)) return target;
    if (!fs::is_regular_file(status)) fail(file, "it is not a regular file");
    if (::access(target.c_str(), W_OK) != 0) fail(file, system_reason(errno));
    return target;
}

struct Descriptor {
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
    const int number;
};

// So that the new name outlives a power cut. Some file systems cannot, and the file is whole without it.
void synchronise_folder(const fs::path& folder) {
    const Descriptor opened(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.number >= 0) ::fsync(opened.number);
}

// A file of its own beside `target`, removed unless it has become the target.
class TemporaryFile {
  public:
    TemporaryFile(const fs::path& file, const fs::path& target) : file_(file), target_(target) {
        std::random_device random;
        int descriptor = -1;
        for (int attempt = 0; attempt < 100 && descriptor < 0; ++attempt) {
            const std::uint64_t id = (std::uint64_t{random()} << 32) | random();
            path_ = target.parent_path() / fmt::format(".nacre-{:016x}{}", id, target.extension().string());
            descriptor = ::open(path_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
            if (descriptor < 0 && errno != EEXIST) break;
        }
        if (descriptor < 0) fail(file, system_reason(errno));
        struct stat old {};
        if (::stat(target.c_str(), &old) == 0) ::fchmod(descriptor, old.st_mode & 07777);
        ::close(descriptor);
    }

    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }

    const fs::path& path() const { return path_; }

    void become_target() {
        synchronise();
        if (::rename(path_.c_str(), target_.c_str()) != 0) fail(file_, system_reason(errno));
        path_.clear();
        synchronise_folder(target_.parent_path());
    }

    // Returns whether `name` was free.
    bool become(const fs::path& name) {
        synchronise();
        if (!rename_if_free(path_, name)) return false;
        path_.clear();
        synchronise_folder(name.parent_path());
        return true;
    }

  private:
    // The bytes are on the disk before the name is: a full disk may show only here.
    void synchronise() const {
        const Descriptor written(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
        if (written.number < 0 || ::fsync(written.number) != 0) fail(file_, system_reason(errno));
    }

    const fs::path& file_;
    const fs::path& target_;
    fs::path path_;
};

// A full disk may show only when the last bytes leave the buffer, on close.
void write_bytes(const fs::path& path, std::string_view bytes, const fs::path& file) {
    std::FILE* const stream = std::fopen(path.c_str(), "wbe");
    if (!stream) fail(file, system_reason(errno));
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
    const int write_error = errno;
    const bool closed = std::fclose(stream) == 0;
    if (!written) fail(file, system_reason(write_error));
    if (!closed) fail(file, system_reason(errno));
}

}  // namespace

fs::path link_target(const fs::path& file) {
    fs::path target = file;
    std::error_code error;
    for (int link = 0; link < links_most && fs::is_symlink(fs::symlink_status(target, error)); ++link) {
        const fs::path next = fs::read_symlink(target, error);
        if (error) break;
        target = target.parent_path() / next;
    }
    return target;
}

void write_file_atomically(const fs::path& file, std::string_view bytes) {
    write_file_atomically(file, [&](const fs::path& temporary) { write_bytes(temporary, bytes, file); });
}

void write_file_atomically(const fs::path& file,
                           const std::function<void(const fs::path& temporary)>& write) {
    const fs::path target = final_target(file);
    TemporaryFile temporary(file, target);
    write(temporary.path());
    temporary.become_target();
}

fs::path write_numbered_file(const fs::path& folder, const std::string& stem, const std::string& extension,
                             const std::function<void(const fs::path& temporary)>& write) {
    const fs::path pattern = folder / (stem + extension);
    TemporaryFile temporary(pattern, pattern);
    write(temporary.path());
    for (int number = 1; number <= numbers_most; ++number) {
        fs::path name = folder / fmt::format("{}-{:03}{}", stem, number, extension);
        std::error_code error;
        if (fs::exists(fs::symlink_status(name, error))) continue;
        if (temporary.become(name)) return name;
        if (!fs::exists(fs::symlink_status(name, error))) fail(name, system_reason(errno));
    }
    fail(pattern, "every number has been taken");
}

bool rename_if_free(const fs::path& from, const fs::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
    // Where the file system has no such renaming, a second link does it as well.
    if (errno != EINVAL && errno != ENOSYS) return false;
    if (::link(from.c_str(), to.c_str()) != 0) return false;
    ::unlink(from.c_str());
    return true;
}

}  // namespace nacre
