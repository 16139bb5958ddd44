#include "core/base/system/memory_file.h"

#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>

#include "core/base/error.h"
#include "core/base/system/system_call.h"

namespace nacre {
namespace {

[[noreturn]] void fail(const char* name, int error) {
    throw UserError(name, "read", "it cannot be kept in memory", system_reason(error));
}

}  // namespace

MemoryFile::MemoryFile(const char* name, std::string_view bytes)
    : descriptor_(::memfd_create(name, MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail(name, errno);
    while (!bytes.empty()) {
        const ssize_t written =
            uninterrupted([&] { return ::write(descriptor_, bytes.data(), bytes.size()); });
        if (written <= 0) {
            const int error = errno;
            ::close(descriptor_);
            fail(name, error);
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

std::filesystem::path MemoryFile::path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

}  // namespace nacre
