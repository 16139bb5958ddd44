#include "core/base/system/quiet.h"

#include <unistd.h>

#include <cstdio>

namespace nacre {
namespace {

thread_local int quiet_depth = 0;

ssize_t write_unless_quiet(void* passed_on, const char* bytes, size_t count) {
    if (quiet_depth > 0) return static_cast<ssize_t>(count);
    auto* const stream = static_cast<FILE*>(passed_on);
    return static_cast<ssize_t>(std::fwrite(bytes, 1, count, stream));
}

// glibc's stderr is a variable that may be set. The stream stays for as long as the program runs.
bool divert_stderr() {
    cookie_io_functions_t functions{};
    functions.write = write_unless_quiet;
    FILE* const diverted = fopencookie(stderr, "w", functions);
    if (diverted == nullptr) return false;
    std::setvbuf(diverted, nullptr, _IONBF, 0);
    stderr = diverted;
    return true;
}

}  // namespace

Quiet::Quiet() {
    [[maybe_unused]] static const bool diverted = divert_stderr();
    ++quiet_depth;
}

Quiet::~Quiet() { --quiet_depth; }

}  // namespace nacre
