// Sums over those of many directions that lie within some angle of another.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

struct WeightedNormal {
    glm::dvec3 normal{0};  // unit
    double weight = 0;
};

// A k-d tree (Bentley 1975) whose nodes know the sum of what they hold: a node that lies within the angle is
// taken whole.
class NormalSums {
  public:
    explicit NormalSums(std::vector<WeightedNormal> normals);

    // The sum of weight times normal over those within `angle` (radians) of the direction. Which normals are
    // within is decided to a quarter of a degree, in steps that grow with the logarithm of their number;
    // `steps`, where given, is raised by how many it took.
    glm::dvec3 within(glm::dvec3 direction, double angle, std::size_t* steps = nullptr) const;

  private:
    struct Node {
        glm::dvec3 middle{0};  // unit
        double radius = 0;     // radians, of a cone about the middle that holds all
        glm::dvec3 sum{0};
    };

    void build(std::size_t node, std::size_t begin, std::size_t end);
    void add(std::size_t node, std::size_t begin, std::size_t end, glm::dvec3 direction, double angle,
             glm::dvec3& sum, std::size_t& steps) const;

    std::vector<WeightedNormal> normals_;
    std::vector<Node> nodes_;  // the children of i are 2 i + 1 and 2 i + 2
};

}  // namespace nacre
