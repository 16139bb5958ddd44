#include <CLI/CLI.hpp>
#include <stdexcept>

#include "app/cli/verbs.h"

namespace nacre::cli {

void declare_unarrived(CLI::App& command, Action& action) {
    command.allow_extras();
    command.callback([&] {
        action = [name = command.get_name()](Interrupt&) -> int {
            throw std::runtime_error(name + ": this verb has not arrived yet");
        };
    });
}

}  // namespace nacre::cli
