#include "core/bake/workers.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace nacre {

struct Workers::Arena {
    explicit Arena(int threads)
        : arena(threads > 0 ? std::min(threads, tbb::info::default_concurrency())
                            : tbb::task_arena::automatic) {}

    tbb::task_arena arena;
};

Workers::Workers(int threads, std::stop_token stop)
    : stop_(std::move(stop)), arena_(std::make_unique<Arena>(threads)) {}

Workers::~Workers() = default;

void Workers::execute(const std::function<void()>& work) { arena_->arena.execute(work); }

void Workers::for_each(int count, const std::function<void(int)>& visit) {
    arena_->arena.execute([&] {
        tbb::parallel_for(0, count, [&](int i) {
            if (!stop_.stop_requested()) visit(i);
        });
    });
    check();
}

}  // namespace nacre
