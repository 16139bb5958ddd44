// The verbs of nacre-cli: one file for each, one line in a list.
#pragma once

#include <functional>
#include <span>

#include "app/cli/interrupt.h"

namespace CLI {
class App;
}

namespace nacre::cli {

// What the command line asks for; returns the exit code, 0 or 1.
using Action = std::function<int(Interrupt&)>;

struct Verb {
    const char* name;
    const char* about;
    // Adds the verb's options to `command`; when it is chosen, `action` becomes its work.
    void (*declare)(CLI::App& command, Action& action);
};

std::span<const Verb> verbs();

void declare_info(CLI::App& command, Action& action);
void declare_eval(CLI::App& command, Action& action);
void declare_tables(CLI::App& command, Action& action);
void declare_bake(CLI::App& command, Action& action);
void declare_render(CLI::App& command, Action& action);
void declare_screenshot(CLI::App& command, Action& action);
void declare_check(CLI::App& command, Action& action);
void declare_report(CLI::App& command, Action& action);
void declare_export(CLI::App& command, Action& action);
void declare_gallery(CLI::App& command, Action& action);
void declare_unarrived(CLI::App& command, Action& action);

}  // namespace nacre::cli
