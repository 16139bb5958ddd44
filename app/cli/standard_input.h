// All of standard input at once.
#pragma once

#include <string>

#include "core/base/system/memory_file.h"

namespace nacre::cli {

// Up to limits::file_bytes_max; what is wrong is a UserError of `standard input`.
std::string read_standard_input();

// The same as a file.
MemoryFile spooled_input();

}  // namespace nacre::cli
