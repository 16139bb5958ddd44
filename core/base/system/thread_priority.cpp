#include "core/base/system/thread_priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace nacre {

void set_niceness(int niceness) { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness); }

}  // namespace nacre
