#include "tests/core/polygon_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace nacre::test {

Flat circle(int n) {
    Flat p;
    for (int i = 0; i < n; ++i)
        p.emplace_back(std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n));
    return p;
}

Flat star(int n) {
    Flat p = circle(n);
    for (std::size_t i = 0; i < p.size(); i += 2) p[i] *= 0.2;
    return p;
}

Flat comb(int n) {
    Flat p;
    for (int i = 0; i < n; ++i) p.emplace_back(i, i % 2 ? 0 : n);
    p.emplace_back(n, -1);
    p.emplace_back(-1, -1);
    std::reverse(p.begin(), p.end());
    return p;
}

Flat spiral(int n) {
    Flat p;
    const int half = n / 2;
    const auto at = [&](int i, double r) {
        const double turn = 2 * std::numbers::pi * 8 * i / half;
        p.emplace_back((r + 1.0 - 0.9 * i / half) * std::cos(turn),
                       (r + 1.0 - 0.9 * i / half) * std::sin(turn));
    };
    for (int i = 0; i < half; ++i) at(i, 0.02);
    for (int i = half - 1; i >= 0; --i) at(i, 0);
    return p;
}

Flat ragged(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(0.05, 1);
    Flat p = circle(n);
    for (glm::dvec2& corner : p) corner *= radius(random);
    return p;
}

Flat snowflake(int depth) {
    Flat p = circle(3);
    for (; depth > 0; --depth) {
        Flat finer;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec2 a = p[i], third = (p[(i + 1) % p.size()] - a) / 3.0;
            const glm::dvec2 outward(third.y, -third.x);
            finer.insert(finer.end(),
                         {a, a + third, a + 1.5 * third + std::sqrt(0.75) * outward, a + 2.0 * third});
        }
        p = finer;
    }
    return p;
}

Flat thorns(int n, unsigned seed) {
    Flat p = ragged(n, seed);
    for (std::size_t i = 0; i < p.size(); i += 2) p[i] *= 0.03;
    return p;
}

Flat plate(int holes) {
    const double width = 3 * holes + 1, height = holes + 3;
    const auto corner = [&](int hole) { return glm::dvec2(3 * hole + 1, holes - hole); };
    Flat p{{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}};
    for (int i = 0; i < holes; ++i)
        for (const glm::dvec2 to : {glm::dvec2(0, 0), {0, 1}, {1, 1}, {1, 0}, {0, 0}})
            p.push_back(corner(i) + to);
    for (int i = holes - 2; i >= 0; --i) p.push_back(corner(i));
    return p;
}

Flat petals(int count) {
    const Flat rim = circle(2 * count);
    Flat p;
    for (std::size_t i = 0; i < rim.size(); i += 2) p.insert(p.end(), {{0, 0}, rim[i], rim[i + 1]});
    return p;
}

Flat parted_square(int parts) {
    const Flat corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Flat p;
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < parts; ++i)
            p.push_back(corners[side] +
                        (corners[(side + 1) % 4] - corners[side]) * (static_cast<double>(i) / parts));
    return p;
}

std::vector<PolygonShape> polygon_shapes() {
    return {{"circle", circle},
            {"star", star},
            {"thorns", [](int n) { return thorns(n, 1); }},
            {"comb", [](int n) { return comb(n + 1); }},
            {"spiral", spiral},
            {"ragged", [](int n) { return ragged(n, 1); }},
            {"snowflake", [](int n) { return snowflake(n > 10000  ? 7
                                                       : n > 1000 ? 5
                                                                  : 3); }},
            {"plate", [](int n) { return plate(n / 6); }},
            {"petals", [](int n) { return petals(n / 3); }},
            {"parted square", [](int n) { return parted_square(n / 4); }}};
}

double n_log_n(std::size_t n) { return static_cast<double>(n) * std::log2(static_cast<double>(n)); }

}  // namespace nacre::test
