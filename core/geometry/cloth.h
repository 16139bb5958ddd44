// A square of woven cloth that falls on a table: extended position-based dynamics in small steps
// (Macklin et al. 2019). Metres, seconds, kilograms; y is up. The same bits in every run.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

// A round plate whose rim is a half circle, its top at y = 0 about the origin.
struct RoundTable {
    double radius = 0.42;
    double rim = 0.03;  // radius of the half circle
};

// From a point to the table's surface, negative inside; `away` is the unit vector from the table.
double distance_to_table(const RoundTable& table, glm::dvec3 point, glm::dvec3& away);

struct ClothMaterial {
    double density = 0.25;  // kg/m^2
    double shear = 8;       // N/m: woven threads turn against each other easily, and hardly stretch
    double bending = 1e-3;  // N m: a stiff one, whose folds stay apart
    double friction = 0.35;
    double thickness = 0.008;  // kept from the table, metres
    double rubbing = 0.2;      // part of two neighbours' relative velocity that they share in a step
    double drag = 1.5;         // part of the velocity lost a second
};

// Points of a square grid: warp threads run along rows, weft threads along columns.
struct Cloth {
    int side = 0;        // points a side
    double spacing = 0;  // at rest
    std::vector<glm::dvec3> points, velocities;

    glm::dvec3& point(int column, int row) { return points[static_cast<std::size_t>(row * side + column)]; }
    const glm::dvec3& point(int column, int row) const {
        return points[static_cast<std::size_t>(row * side + column)];
    }
};

// Flat above the table's middle, turned by `turn` degrees, each point off its height by a tenth of a
// millimetre or less as `seed` has it.
Cloth flat_cloth(int side, double breadth, double turn, unsigned seed);

// A grid with a point more between each two.
Cloth refined(const Cloth& cloth);

// Lets it fall for some seconds, in steps of some of a second: threads stretch by what a sweep over them a
// step leaves, less in shorter ones.
void let_fall(Cloth& cloth, const RoundTable& table, const ClothMaterial& material, double seconds,
              double step);

}  // namespace nacre
