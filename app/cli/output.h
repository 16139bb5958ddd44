// Where the one file of a verb goes.
#pragma once

#include <string>
#include <string_view>

#include "app/cli/message.h"
#include "core/base/system/interrupt.h"
#include "core/base/system/standard_streams.h"

namespace nacre::cli {

// As DESIGN it is standard input, as an output standard output.
inline constexpr std::string_view stream_name = "-";

// The bytes as the file, or on standard output where it is "-".
void write_file_or_output(const std::string& file, std::string_view bytes, Interrupt& interrupt);

}  // namespace nacre::cli
