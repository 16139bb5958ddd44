// The verbs of nacre-cli: one file for each, one line in a list.
#pragma once

#include <functional>
#include <span>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"

namespace nacre::cli {

// What the command line asks for; returns the exit code, 0 or 1.
using Action = std::function<int(Interrupt&)>;

struct Verb {
    const char* name;
    const char* about;
    // Adds the verb's options to `command`; when it is chosen, `action` becomes its work.
    void (*declare)(Command& command, Action& action);
};

std::span<const Verb> verbs();

void declare_info(Command& command, Action& action);
void declare_eval(Command& command, Action& action);
void declare_tables(Command& command, Action& action);
void declare_bake(Command& command, Action& action);
void declare_render(Command& command, Action& action);
void declare_plot(Command& command, Action& action);
void declare_screenshot(Command& command, Action& action);
void declare_check(Command& command, Action& action);
void declare_report(Command& command, Action& action);
void declare_export(Command& command, Action& action);
void declare_gallery(Command& command, Action& action);
void declare_unarrived(Command& command, Action& action);

}  // namespace nacre::cli
