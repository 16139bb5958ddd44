#include "app/cli/bake_options.h"

#include <CLI/CLI.hpp>

namespace nacre::cli {

void add_tolerance_option(CLI::App& command, BakeOptions& options) {
    command
        .add_option("--tolerance", options.tolerance,
                    "the error that the tables are made for: of g relative, of R absolute (default: 1e-3); "
                    "all of them together never take more than 64 KiB")
        ->check(CLI::Range(1e-5, 0.1));
}

}  // namespace nacre::cli
