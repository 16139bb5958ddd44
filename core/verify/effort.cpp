#include "core/verify/effort.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace nacre {

int visit_within(double seconds, int count, int least, const std::function<void(int)>& visit,
                 const std::function<void(double)>& progress) {
    const Effort effort(seconds), quarter(0.25 * seconds);
    int done = 0, step = tbb::this_task_arena::max_concurrency();
    while (done < count && (done < least || effort.left())) {
        const int end = std::min(done + step, count);
        tbb::parallel_for(done, end, visit);
        done = end;
        if (quarter.left()) step *= 2;
        if (progress) progress(static_cast<double>(done) / count);
    }
    return done;
}

}  // namespace nacre
