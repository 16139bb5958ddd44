#include "core/paint/polygon_cover.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace nacre {
namespace {

constexpr int lines_a_pixel = 4;

// Where a line along x meets a side, and whether the side goes down there.
struct Crossing {
    double x;
    int turn;
};

std::vector<Crossing> crossings(std::span<const glm::dvec2> outline, double y) {
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        found.push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), b.y > a.y ? 1 : -1});
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    return found;
}

}  // namespace

PolygonCover::PolygonCover(std::span<const glm::dvec2> outline) {
    if (outline.size() < 3) return;
    glm::dvec2 low = outline.front(), high = low;
    for (const glm::dvec2& corner : outline) low = glm::min(low, corner), high = glm::max(high, corner);
    low_ = glm::ivec2(glm::floor(low));
    size_ = glm::ivec2(glm::floor(high)) - low_ + 1;
    amounts_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    for (int line = 0; line < size_.y * lines_a_pixel; ++line) {
        int turns = 0;
        double from = 0;
        for (const Crossing& crossing : crossings(outline, low_.y + (line + 0.5) / lines_a_pixel)) {
            if (turns == 0) from = crossing.x;
            turns += crossing.turn;
            if (turns == 0)
                add_span(line / lines_a_pixel, from - low_.x, crossing.x - low_.x, 1.0f / lines_a_pixel);
        }
    }
}

void PolygonCover::add_span(int row, double from, double to, float weight) {
    for (int column = static_cast<int>(from); column < size_.x && column < to; ++column) {
        const double part = std::min(to, column + 1.0) - std::max(from, static_cast<double>(column));
        amounts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x) +
                 static_cast<std::size_t>(column)] += weight * static_cast<float>(part);
    }
}

float PolygonCover::pixel(int column, int row) const {
    if (column < 0 || row < 0 || column >= size_.x || row >= size_.y) return 0;
    return amounts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x) +
                    static_cast<std::size_t>(column)];
}

double PolygonCover::operator()(glm::dvec2 at) const {
    const glm::dvec2 place = at - 0.5 - glm::dvec2(low_), corner = glm::floor(place);
    if (place.x < -1 || place.y < -1 || place.x > size_.x || place.y > size_.y) return 0;
    const int i = static_cast<int>(corner.x), j = static_cast<int>(corner.y);
    const glm::dvec2 part = place - corner;
    const auto along = [&](int row) {
        return std::lerp(static_cast<double>(pixel(i, row)), static_cast<double>(pixel(i + 1, row)), part.x);
    };
    return std::clamp(std::lerp(along(j), along(j + 1), part.y), 0.0, 1.0);
}

}  // namespace nacre
