// The verbs of nacre-cli: one file for each, NAME_verb.cpp, and its line in verb_list.inc.
#pragma once

#include <functional>
#include <span>

#include "app/cli/command.h"
#include "core/base/system/interrupt.h"

namespace nacre::cli {

// What the command line asks for; returns the exit code, 0 or 1.
using Action = std::function<int(Interrupt&)>;

struct Verb {
    const char* name;
    const char* about;
    // Adds the verb's options to `command`; when it is chosen, `action` becomes its work.
    void (*declare)(Command& command, Action& action);
};

std::span<const Verb* const> verbs();

#define VERB(name) extern const Verb name##_verb;
#include "app/cli/verb_list.inc"
#undef VERB

}  // namespace nacre::cli
