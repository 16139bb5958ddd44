#include "app/cli/message.h"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "core/design/error.h"
#include "core/exchange/system_call.h"

namespace nacre::cli {

void complain(std::string_view what) {
    write_message(fmt::format("nacre-cli: {}\n", one_line(what)), std::chrono::seconds(10));
}

void write_message(std::string_view text, std::chrono::milliseconds patience) {
    while (!text.empty()) {
        pollfd error{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
        if (uninterrupted([&] { return ::poll(&error, 1, static_cast<int>(patience.count())); }) <= 0) return;
        const ssize_t written =
            uninterrupted([&] { return ::write(STDERR_FILENO, text.data(), text.size()); });
        if (written < 0 && errno == EAGAIN) continue;
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace nacre::cli
