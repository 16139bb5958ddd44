// A picture of fewer pixels, made row by row.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

// Each pixel of `to` is the mean over the area of `from` that lies there, also where it has more of them.
class FittedAverage {
  public:
    FittedAverage(glm::ivec2 from, glm::ivec2 to);
    // Each row of `from` once, in any order.
    void add(int y, const std::vector<glm::dvec3>& row);
    std::vector<glm::vec3> result() const;

  private:
    struct Share {
        std::size_t first;
        std::vector<double> parts;
    };
    static std::vector<Share> shares(int from, int to);

    std::vector<Share> across_, down_;  // of a pixel, the shares that it gives to the new ones
    std::vector<glm::dvec3> sums_, row_;
};

}  // namespace nacre
