#include "app/desktop/start_report.h"

#include <cstdio>

#include "core/base/system/process_times.h"

namespace nacre {

void report_stage(const char* stage) {
    std::printf("%s %.3f %.3f\n", stage, seconds_since_start(), processor_seconds());
}

}  // namespace nacre
