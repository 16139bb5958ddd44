#include "core/base/system/process_times.h"

#include <time.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <string>

namespace nacre {
namespace {

double read_clock(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Since the machine was started, proc(5), /proc/pid/stat, field 22.
double process_begin() {
    std::ifstream stat("/proc/self/stat");
    stat.ignore(std::numeric_limits<std::streamsize>::max(), ')');  // the name may hold anything
    std::string skipped;
    for (int field = 3; field < 22; ++field) stat >> skipped;
    double ticks = 0;
    stat >> ticks;
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

double processor_seconds() { return read_clock(CLOCK_PROCESS_CPUTIME_ID); }

double seconds_since_start() { return read_clock(CLOCK_BOOTTIME) - process_begin(); }

}  // namespace nacre
