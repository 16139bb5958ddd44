#include "tests/bench/report.h"

#include <fmt/core.h>

#include <algorithm>

namespace nacre::bench {

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::string duration(double seconds) {
    if (seconds < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
    if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.3g} s", seconds);
}

void Report::print(std::FILE* file) const {
    if (lines_.empty()) return;
    std::size_t width = 4;
    for (const Line& line : lines_) width = std::max(width, line.what.size());
    fmt::print(file, "\n{:{}}  {:>9}  {:>9}  {:>9}  {:>10}\n", "what", width, "ours", "theirs", "ratio",
               "wanted");
    for (const Line& line : lines_)
        fmt::print(file, "{:{}}  {:>9}  {:>9}  {:>9}  {:>10}  {}\n", line.what, width, line.ours, line.theirs,
                   line.ratio, line.wanted, line.remark + (line.met ? "" : " NOT MET"));
}

Line at_most_times(std::string what, Pair pair, double wanted) {
    const double ratio = pair.ours / pair.theirs;
    return {std::move(what),
            duration(pair.ours),
            duration(pair.theirs),
            fmt::format("{:.2f} x", ratio),
            fmt::format("<= {:g} x", wanted),
            ratio <= wanted};
}

Line faster(std::string what, Pair pair, double wanted) {
    const double speed = pair.theirs / pair.ours;
    return {std::move(what),
            duration(pair.ours),
            duration(pair.theirs),
            fmt::format("1/{:.4g}", speed),
            fmt::format("1/{:g}", wanted),
            speed >= wanted};
}

Line compared(std::string what, Pair pair) {
    const double ratio = pair.ours / pair.theirs;
    return {std::move(what), duration(pair.ours), duration(pair.theirs),
            ratio < 1 ? fmt::format("1/{:.4g}", 1 / ratio) : fmt::format("{:.2f} x", ratio), ""};
}

Line within(std::string what, double seconds, double wanted) {
    return {std::move(what),  duration(seconds), "", "", fmt::format("< {}", duration(wanted)),
            seconds <= wanted};
}

}  // namespace nacre::bench
