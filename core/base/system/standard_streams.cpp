#include "core/base/system/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <initializer_list>

#include "core/base/error.h"
#include "core/base/system/system_call.h"

namespace nacre {
namespace {

constexpr int for_ever = -1;

// poll(2) of one descriptor.
int wait_for(int descriptor, short events, int milliseconds) {
    pollfd one{.fd = descriptor, .events = events, .revents = 0};
    return ::poll(&one, 1, milliseconds);
}

}  // namespace

void prepare_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest number that is free is this one. It is open the wrong way round.
        [[maybe_unused]] const int opened =
            ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool input_is_ready(std::chrono::milliseconds patience) {
    const int ready = wait_for(STDIN_FILENO, POLLIN, static_cast<int>(patience.count()));
    return ready > 0 || (ready < 0 && errno != EINTR);  // reading tells what is wrong
}

void wait_for_input() { wait_for(STDIN_FILENO, POLLIN, for_ever); }

std::optional<std::size_t> read_input(char* to, std::size_t length) {
    const ssize_t count = uninterrupted([&] { return ::read(STDIN_FILENO, to, length); });
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EAGAIN) return {};
    throw UserError(standard_input, "read", "it cannot be read", system_reason(errno));
}

std::optional<std::uintmax_t> input_size() {
    struct stat status {};
    if (::fstat(STDIN_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return static_cast<std::uintmax_t>(status.st_size);
}

void write_output(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written =
            uninterrupted([&] { return ::write(STDOUT_FILENO, text.data(), text.size()); });
        if (written < 0 && errno == EAGAIN) {
            wait_for(STDOUT_FILENO, POLLOUT, for_ever);
            continue;
        }
        if (written < 0 && errno == EPIPE) throw ReaderGone();
        if (written < 0)
            throw UserError("standard output", "write", "it cannot be written", system_reason(errno));
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void write_message(std::string_view text, std::chrono::milliseconds patience) {
    while (!text.empty()) {
        const int milliseconds = static_cast<int>(patience.count());
        if (uninterrupted([&] { return wait_for(STDERR_FILENO, POLLOUT, milliseconds); }) <= 0) return;
        const ssize_t written =
            uninterrupted([&] { return ::write(STDERR_FILENO, text.data(), text.size()); });
        if (written < 0 && errno == EAGAIN) continue;
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

bool output_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace nacre
