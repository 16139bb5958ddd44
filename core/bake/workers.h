// The threads of one bake.
#pragma once

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>
#include <stop_token>
#include <utility>

namespace nacre {

struct BakeCancelled : std::runtime_error {
    BakeCancelled() : std::runtime_error("the bake was stopped") {}
};

class Workers {
  public:
    // threads = 0, or more than the machine has: as many as it has.
    explicit Workers(int threads, std::stop_token stop = {})
        : stop_(std::move(stop)),
          arena_(threads > 0 ? std::min(threads, tbb::info::default_concurrency())
                             : tbb::task_arena::automatic) {}

    void check() const {
        if (stop_.stop_requested()) throw BakeCancelled();
    }

    // Runs `work`, so that what it starts in parallel keeps to these threads.
    template <class Work>
    auto run(const Work& work) {
        return arena_.execute(work);
    }

    // Calls visit(i) for every i below `count`; results must not depend on order. Throws BakeCancelled.
    template <class Visit>
    void for_each(int count, const Visit& visit) {
        arena_.execute([&] {
            tbb::parallel_for(0, count, [&](int i) {
                if (!stop_.stop_requested()) visit(i);
            });
        });
        check();
    }

  private:
    std::stop_token stop_;
    tbb::task_arena arena_;
};

}  // namespace nacre
