// The preview's environment light against core's own integral of the same picture.
#pragma once

#include <memory>
#include <vector>

#include "app/preview/preview.h"
#include "core/bake/tables.h"
#include "core/light/environment.h"

namespace nacre::test {

// Points of the sphere in a picture of `side` x `side` pixels, the same in every run: all pixels that it
// covers whole, every so many of them.
struct ViewedPoints {
    ViewedPoints(Preview& preview, int side, int count);

    Scene scene;
    int side;
    std::vector<glm::ivec2> pixels;  // from the top left corner
    std::vector<glm::dmat3> frames;  // tangent, bitangent, normal in view space
};

// What each point sends to the viewer, by RadianceIntegral.
std::vector<glm::dvec3> integrals(const ViewedPoints& points, const std::shared_ptr<const Tables>& tables,
                                  const std::shared_ptr<const Environment>& environment, int fineness);

// The same in a picture of so many samples, which shows `tables`.
std::vector<glm::dvec3> accumulated(Preview& preview, const ViewedPoints& points,
                                    const std::shared_ptr<const Environment>& environment, int samples);

// Root mean square difference over points and colours, in parts of the mean of `exact`.
double relative_error(const std::vector<glm::dvec3>& values, const std::vector<glm::dvec3>& exact);

}  // namespace nacre::test
