#include "core/base/system/open_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

namespace nacre {

OpenFile::OpenFile(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (descriptor_.number < 0 || ::fstat(descriptor_.number, &status) != 0)
        throw std::system_error(errno, std::generic_category());
    size_ = static_cast<std::uint64_t>(status.st_size);
}

std::size_t OpenFile::read(std::uint64_t offset, void* to, std::size_t length) const {
    std::size_t done = 0;
    while (done < length) {
        const ssize_t count = uninterrupted([&] {
            return ::pread(descriptor_.number, static_cast<char*>(to) + done, length - done,
                           static_cast<off_t>(offset + done));
        });
        if (count <= 0) break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

std::filesystem::path OpenFile::path() const { return fmt::format("/proc/self/fd/{}", descriptor_.number); }

}  // namespace nacre
