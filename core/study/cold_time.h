// How long something takes the processor, whatever else runs beside it.
#pragma once

#include <algorithm>
#include <utility>

#include "core/base/system/process_times.h"

namespace nacre {

template <class Result>
struct Timed {
    Result result;
    double seconds;
};

// The shortest of several runs: up to five, until they take half a second together.
template <class Make>
auto time_from_cold(const Make& make) -> Timed<decltype(make())> {
    auto once = [&] {
        const double begin = processor_seconds();
        auto result = make();
        return Timed<decltype(make())>{std::move(result), processor_seconds() - begin};
    };
    Timed<decltype(make())> best = once();
    double total = best.seconds;
    for (int run = 1; run < 5 && total < 0.5; ++run) {
        const double seconds = once().seconds;
        total += seconds;
        best.seconds = std::min(best.seconds, seconds);
    }
    return best;
}

}  // namespace nacre
