#include "core/exchange/log_axis.h"

#include <fmt/core.h>

#include <algorithm>

namespace nacre {

std::string tick_label(ChartUnit unit, int decade) {
    auto plain = [](int exponent) {
        return exponent >= 0 ? fmt::format("{:.0f}", std::pow(10, exponent))
                             : fmt::format("{:.{}f}", std::pow(10, exponent), -exponent);
    };
    switch (unit) {
        case ChartUnit::seconds:
            if (decade >= 0) return plain(decade) + " s";
            if (decade >= -3) return plain(decade + 3) + " ms";
            if (decade >= -6) return plain(decade + 6) + " µs";
            return plain(decade + 9) + " ns";
        case ChartUnit::percent:
            return plain(decade + 2) + " %";
        case ChartUnit::parts:
            break;
    }
    return plain(decade);
}

LogRange range_of(const std::vector<double>& values) {
    if (values.empty()) return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {std::log10(*least), std::log10(*most)};
}

LogRange whole_decades(LogRange range) {
    const double low = std::floor(range.low + 1e-9);
    return {low, std::max(low + 1, std::ceil(range.high - 1e-9))};
}

LogRange with_margin(LogRange range) {
    const double margin = std::max(0.04 * (range.high - range.low), 0.5 * (1 - range.high + range.low));
    return {range.low - margin, range.high + margin};
}

}  // namespace nacre
