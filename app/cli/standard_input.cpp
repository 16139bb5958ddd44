#include "app/cli/standard_input.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

#include "core/design/design.h"
#include "core/design/error.h"
#include "core/exchange/system_call.h"

namespace nacre::cli {
namespace {

constexpr std::size_t block = 1u << 20;  // bytes that are read at once

[[noreturn]] void fail(const std::string& why) {
    throw UserError(standard_input, "read", "it cannot be read", why);
}

}  // namespace

std::string read_standard_input() {
    std::string text;
    for (;;) {
        const std::size_t kept = text.size();
        text.resize(kept + block);
        const ssize_t count = uninterrupted([&] { return ::read(STDIN_FILENO, text.data() + kept, block); });
        const int error = errno;
        text.resize(kept + (count > 0 ? static_cast<std::size_t>(count) : 0));
        if (count == 0) return text;
        if (count < 0 && error != EAGAIN) fail(system_reason(error));
        if (text.size() > limits::file_bytes_max)
            fail(fmt::format("more than the {} bytes that are read", limits::file_bytes_max));
        if (count > 0) continue;
        pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
        ::poll(&input, 1, -1);
    }
}

SpooledInput::SpooledInput() {
    const std::string bytes = read_standard_input();
    descriptor_ = ::memfd_create(standard_input, MFD_CLOEXEC);
    if (descriptor_ < 0) fail(system_reason(errno));
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t written = uninterrupted([&] { return ::write(descriptor_, rest.data(), rest.size()); });
        if (written <= 0) {
            const int error = errno;
            ::close(descriptor_);
            fail(system_reason(error));
        }
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
}

SpooledInput::~SpooledInput() { ::close(descriptor_); }

std::filesystem::path SpooledInput::path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

}  // namespace nacre::cli
