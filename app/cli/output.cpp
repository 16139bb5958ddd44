#include "app/cli/output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/design/error.h"

namespace nacre::cli {

void write_output(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0 && errno == EPIPE) throw ReaderGone();
        if (written < 0)
            throw UserError("standard output", "write", "it cannot be written",
                            std::generic_category().message(errno));
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void warn(std::string_view about, std::string_view message) {
    fmt::print(stderr, "nacre-cli: {}\n", one_line(fmt::format("{}: {}", about, message)));
}

bool output_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

}  // namespace nacre::cli
