#include "core/pictures/fitted_average.h"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>

namespace nacre {

std::vector<FittedAverage::Share> FittedAverage::shares(int from, int to) {
    std::vector<Share> shares;
    for (std::int64_t i = 0; i < from; ++i) {
        // In units of 1/(from to) of the whole, so that all is exact.
        const std::int64_t start = i * to, end = start + to;
        Share share{static_cast<std::size_t>(start / from), {}};
        for (std::int64_t j = start / from; j * from < end; ++j) {
            const std::int64_t overlap = std::min(end, (j + 1) * from) - std::max(start, j * from);
            share.parts.push_back(static_cast<double>(overlap) / from);
        }
        shares.push_back(std::move(share));
    }
    return shares;
}

FittedAverage::FittedAverage(glm::ivec2 from, glm::ivec2 to)
    : across_(shares(from.x, to.x)),
      down_(shares(from.y, to.y)),
      sums_(static_cast<std::size_t>(to.x) * static_cast<std::size_t>(to.y)),
      row_(static_cast<std::size_t>(to.x)) {}

void FittedAverage::add(int y, const std::vector<glm::dvec3>& row) {
    std::fill(row_.begin(), row_.end(), glm::dvec3(0));
    for (std::size_t x = 0; x < row.size(); ++x)
        for (std::size_t j = 0; j < across_[x].parts.size(); ++j)
            row_[across_[x].first + j] += row[x] * across_[x].parts[j];
    const Share& down = down_[static_cast<std::size_t>(y)];
    for (std::size_t i = 0; i < down.parts.size(); ++i) {
        glm::dvec3* const sum = &sums_[(down.first + i) * row_.size()];
        for (std::size_t x = 0; x < row_.size(); ++x) sum[x] += row_[x] * down.parts[i];
    }
}

std::vector<glm::vec3> FittedAverage::result() const {
    constexpr double most = std::numeric_limits<float>::max();
    std::vector<glm::vec3> means;
    means.reserve(sums_.size());
    for (const glm::dvec3& sum : sums_) means.emplace_back(glm::min(sum, glm::dvec3(most)));
    return means;
}

}  // namespace nacre
