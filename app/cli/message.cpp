#include "app/cli/message.h"

#include <fmt/core.h>

#include "core/base/error.h"
#include "core/base/system/standard_streams.h"

namespace nacre::cli {

void complain(std::string_view what) {
    write_message(fmt::format("nacre-cli: {}\n", one_line(what)), std::chrono::seconds(10));
}

void warn(std::string_view about, std::string_view message) {
    complain(fmt::format("{}: {}", about, message));
}

}  // namespace nacre::cli
