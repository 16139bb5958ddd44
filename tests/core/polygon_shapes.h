// Polygons that turn counterclockwise: convex, jagged, wound, and such as touch themselves.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace nacre::test {

using Flat = std::vector<glm::dvec2>;

Flat circle(int n);

// Long thin points, all of one length or of any.
Flat star(int n);
Flat thorns(int n, unsigned seed);

// An odd number of teeth's ends, n high.
Flat comb(int n);

// A band that winds inward, and comes back along itself.
Flat spiral(int n);

Flat ragged(int n, unsigned seed);

// Each edge of Koch's curve is four of the next.
Flat snowflake(int depth);

// With square holes, which turn the other way: each joined to the one before, the first to a corner of the
// plate. Every joining edge stands twice.
Flat plate(int holes);

// Triangles that share one corner.
Flat petals(int count);

// The sides of a square in so many parts each.
Flat parted_square(int parts);

// All of them by name, each of about n corners; n is 300 or more.
struct PolygonShape {
    std::string name;
    std::function<Flat(int n)> make;
};
std::vector<PolygonShape> polygon_shapes();

// n log2 n.
double n_log_n(std::size_t n);

}  // namespace nacre::test
