#include <stdexcept>

#include "app/cli/verbs.h"

namespace nacre::cli {

void declare_unarrived(Command& command, Action& action) {
    command.ignore_further_words();
    command.when_chosen([name = command.name(), &action] {
        action = [name](Interrupt&) -> int {
            throw std::runtime_error(name + ": this verb has not arrived yet");
        };
    });
}

}  // namespace nacre::cli
