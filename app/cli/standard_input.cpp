#include "app/cli/standard_input.h"

#include <fmt/core.h>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/system/standard_streams.h"

namespace nacre::cli {

constexpr std::size_t block = 1u << 20;  // bytes that are read at once

std::string read_standard_input() {
    std::string text;
    for (;;) {
        const std::size_t kept = text.size();
        text.resize(kept + block);
        const auto count = read_input(text.data() + kept, block);
        text.resize(kept + count.value_or(0));
        if (!count) wait_for_input();
        if (count == 0) return text;
        if (text.size() > limits::file_bytes_max)
            throw UserError(standard_input, "read", "it cannot be read",
                            fmt::format("more than the {} bytes that are read", limits::file_bytes_max));
    }
}

MemoryFile spooled_input() { return MemoryFile(standard_input, read_standard_input()); }

}  // namespace nacre::cli
