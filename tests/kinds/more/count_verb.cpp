#include <fmt/core.h>

#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"

namespace nacre::cli {
namespace {

void declare(Command& command, Action& action) {
    const auto design = std::make_shared<std::string>();
    command.option("DESIGN", *design, "a .nacre file").required();
    command.when_chosen([design, &action] {
        action = [design](Interrupt&) {
            write_output(fmt::format("{}\n", read_design(*design).distribution.layers.size()));
            return 0;
        };
    });
}

}  // namespace

const Verb count_verb{"count", "how many layers a design has", declare};

}  // namespace nacre::cli
