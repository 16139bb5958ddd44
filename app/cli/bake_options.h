// Options of the verbs that bake.
#pragma once

#include "app/cli/command.h"
#include "core/bake/bake.h"

namespace nacre::cli {

// --tolerance: the error that the tables' size is chosen for.
void add_tolerance_option(Command& command, BakeOptions& options);

}  // namespace nacre::cli
