// How long something takes.
#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

namespace nacre {

template <class Result>
struct Timed {
    Result result;
    double seconds;
};

// The shortest of several runs: up to five, until they take half a second together.
template <class Make>
auto time_from_cold(const Make& make) -> Timed<decltype(make())> {
    using Clock = std::chrono::steady_clock;
    auto once = [&] {
        const auto begin = Clock::now();
        auto result = make();
        return Timed<decltype(make())>{std::move(result),
                                       std::chrono::duration<double>(Clock::now() - begin).count()};
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
