#include "app/cli/output.h"

#include "core/base/system/atomic_file.h"

namespace nacre::cli {

void write_file_or_output(const std::string& file, std::string_view bytes, Interrupt& interrupt) {
    if (file == stream_name) {
        write_output(bytes);
    } else {
        interrupt.write_files([&] { write_file_atomically(file, bytes); });
    }
}

}  // namespace nacre::cli
