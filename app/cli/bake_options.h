// Options of the verbs that bake.
#pragma once

#include "core/bake/bake.h"

namespace CLI {
class App;
}

namespace nacre::cli {

// --tolerance: the error that the tables' size is chosen for.
void add_tolerance_option(CLI::App& command, BakeOptions& options);

}  // namespace nacre::cli
