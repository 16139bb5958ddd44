#include "app/cli/output.h"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "app/cli/message.h"
#include "core/design/error.h"
#include "core/exchange/atomic_file.h"
#include "core/exchange/system_call.h"

namespace nacre::cli {

void write_output(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written =
            uninterrupted([&] { return ::write(STDOUT_FILENO, text.data(), text.size()); });
        if (written < 0 && errno == EAGAIN) {
            pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
            ::poll(&output, 1, -1);
            continue;
        }
        if (written < 0 && errno == EPIPE) throw ReaderGone();
        if (written < 0)
            throw UserError("standard output", "write", "it cannot be written", system_reason(errno));
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void warn(std::string_view about, std::string_view message) {
    complain(fmt::format("{}: {}", about, message));
}

void write_file_or_output(const std::string& file, std::string_view bytes, Interrupt& interrupt) {
    if (file == stream_name) {
        write_output(bytes);
    } else {
        interrupt.write_files([&] { write_file_atomically(file, bytes); });
    }
}

bool output_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

}  // namespace nacre::cli
