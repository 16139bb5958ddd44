#include "core/model/disk_quadrature.h"

namespace nacre {

std::vector<double> cuts_between(double low, double high, int side) {
    std::vector<double> at = {low};
    if (side > 0) {
        const double slack = 1e-9 / side;
        const int first = std::max(static_cast<int>(std::floor((low + 1) / 2 * side - 0.5)), 0);
        for (int i = first; i < side && middle_of(side, i) < high - slack; ++i)
            if (middle_of(side, i) > low + slack) at.push_back(middle_of(side, i));
    }
    if (low < 0 && high > 0) at.push_back(0);
    at.push_back(high);
    std::sort(at.begin(), at.end());
    return at;
}

void visit_disk(int side, int other_side, const std::function<void(dvec2 at, double solid_angle)>& visit) {
    std::vector<double> stops;
    for (const int of : {side, other_side}) {
        const std::vector<double> part = cuts_between(-1, 1, of);
        stops.insert(stops.end(), part.begin(), part.end());
    }
    std::sort(stops.begin(), stops.end());
    const auto same = [](double a, double b) { return b - a < 1e-12; };
    stops.erase(std::unique(stops.begin(), stops.end(), same), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
        for (std::size_t j = 0; j + 1 < stops.size(); ++j)
            visit_in_disk({{stops[j], stops[i]}, {stops[j + 1], stops[i + 1]}},
                          [&](dvec2 at, double area) { visit(at, 2 * area); });
}

}  // namespace nacre
