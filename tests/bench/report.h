// The table of ratios that nacre-bench prints at the end, and how a ratio is measured.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace nacre::bench {

// One comparison: what was wanted of it stands beside what was measured.
struct Line {
    std::string what;
    std::string ours;
    std::string theirs;
    std::string ratio;
    std::string wanted;
    bool met = true;
    std::string remark = {};
};

class Report {
  public:
    void add(Line line) { lines_.push_back(std::move(line)); }
    void print(std::FILE* file) const;

  private:
    std::vector<Line> lines_;
};

double median(std::vector<double> values);

// 12.3 ns, 4.56 us, 7.89 ms or 1.23 s.
std::string duration(double seconds);

template <class Work>
double seconds_of(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    benchmark::ClobberMemory();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The same of the processor, of all threads together: other programs change it little.
template <class Work>
double processor_seconds_of(const Work& work) {
    const std::clock_t begin = std::clock();
    work();
    benchmark::ClobberMemory();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

enum class Time { wall, processor };

// Medians over the repetitions, seconds.
struct Pair {
    double ours = 0;
    double theirs = 0;
};

// Times ours and theirs in turn, so that whatever else the machine does hits both. The benchmark's own time
// is ours; both are counters, divided by `items`, what one call works off.
template <class Ours, class Theirs>
Pair interleave(benchmark::State& state, double items, const Ours& ours, const Theirs& theirs,
                Time time = Time::wall) {
    const auto taken = [time](const auto& work) {
        return time == Time::wall ? seconds_of(work) : processor_seconds_of(work);
    };
    std::vector<double> a, b;
    for ([[maybe_unused]] auto _ : state) {
        const bool ours_first = a.size() % 2 == 0;
        if (ours_first) a.push_back(taken(ours));
        b.push_back(taken(theirs));
        if (!ours_first) a.push_back(taken(ours));
        state.SetIterationTime(a.back());
    }
    const Pair pair{median(a) / items, median(b) / items};
    state.counters["ours_s"] = pair.ours;
    state.counters["theirs_s"] = pair.theirs;
    return pair;
}

// The median time of ours alone, seconds.
template <class Ours>
double repeat(benchmark::State& state, const Ours& ours) {
    std::vector<double> times;
    for ([[maybe_unused]] auto _ : state) {
        times.push_back(seconds_of(ours));
        state.SetIterationTime(times.back());
    }
    state.counters["ours_s"] = median(times);
    return median(times);
}

// `work` is called with the benchmark's state, `repetitions` times are measured.
template <class Work>
void add_benchmark(const std::string& name, int repetitions, Work work) {
    benchmark::RegisterBenchmark(name.c_str(), std::move(work))
        ->Iterations(repetitions)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
}

Line at_most_times(std::string what, Pair pair, double wanted);  // ours over theirs
Line faster(std::string what, Pair pair, double wanted);         // theirs over ours
Line compared(std::string what, Pair pair);                      // nothing is wanted
Line within(std::string what, double seconds, double wanted);

}  // namespace nacre::bench
