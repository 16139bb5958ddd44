#include "app/desktop/start_report.h"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

namespace nacre {
namespace {

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

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

void report_stage(const char* stage) {
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const double wall =
        static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 - process_begin();
    std::printf("%s %.3f %.3f\n", stage, wall, seconds_of(used.ru_utime) + seconds_of(used.ru_stime));
}

}  // namespace nacre
