// What a verb answers, and where its one file goes.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "app/cli/interrupt.h"

namespace nacre::cli {

// As DESIGN it is standard input, as an output standard output.
inline constexpr std::string_view stream_name = "-";

// Whoever read the answers has gone.
struct ReaderGone : std::runtime_error {
    ReaderGone() : std::runtime_error("nobody reads the output") {}
};

// Writes through to standard output; a failure is a UserError of `standard output`, or ReaderGone.
void write_output(std::string_view text);

// The bytes as the file, or on standard output where it is "-".
void write_file_or_output(const std::string& file, std::string_view bytes, Interrupt& interrupt);

bool output_is_terminal();

// One line on standard error about what is done nonetheless.
void warn(std::string_view about, std::string_view message);

}  // namespace nacre::cli
