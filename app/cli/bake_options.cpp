#include "app/cli/bake_options.h"

namespace nacre::cli {

void add_tolerance_option(Command& command, BakeOptions& options) {
    command
        .option("--tolerance", options.tolerance,
                "the error that the tables are made for: of g relative, of R absolute (default: 1e-3); "
                "all of them together take at most 64 KiB, or 256 KiB where that does not suffice")
        .within(1e-5, 0.1);
}

}  // namespace nacre::cli
