// Standard output: what a verb answers.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace nacre::cli {

// Whoever read the answers has gone.
struct ReaderGone : std::runtime_error {
    ReaderGone() : std::runtime_error("nobody reads the output") {}
};

// Writes through to the descriptor; a failure is a UserError of `standard output`, or ReaderGone.
void write_output(std::string_view text);

bool output_is_terminal();

// One line on standard error about what is done nonetheless.
void warn(std::string_view about, std::string_view message);

}  // namespace nacre::cli
