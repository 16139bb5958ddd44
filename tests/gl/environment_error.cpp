#include "tests/gl/environment_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/verify/reflected_radiance.h"

namespace nacre::test {

ViewedPoints::ViewedPoints(Preview& preview, int side_of_picture, int count) : side(side_of_picture) {
    const SurfaceImage& surface = preview.surface(scene, {side, side});
    const double unit = pixels_per_unit(scene, {side, side});
    std::vector<glm::ivec2> whole;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec2 at = glm::dvec2(x + 0.5, y + 0.5) - 0.5 * side;
            if (surface.at({x + 0.5, y + 0.5}) && std::hypot(at.x, at.y) + 0.75 < unit)
                whole.emplace_back(x, y);
        }
    const std::size_t step = std::max<std::size_t>(whole.size() / static_cast<std::size_t>(count), 1);
    for (std::size_t i = step / 2; i < whole.size(); i += step) {
        pixels.push_back(whole[i]);
        frames.push_back(surface.at(glm::dvec2(whole[i]) + 0.5)->frame);
    }
}

std::vector<glm::dvec3> integrals(const ViewedPoints& points, const std::shared_ptr<const Tables>& tables,
                                  const std::shared_ptr<const Environment>& environment, int fineness) {
    const RadianceIntegral integral(tables, environment, fineness);
    std::vector<glm::dvec3> values(points.frames.size());
    tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
        const glm::dmat3& frame = points.frames[i];
        values[i] = integral(frame, {frame[0].z, frame[1].z, frame[2].z});
    });
    return values;
}

std::vector<glm::dvec3> accumulated(Preview& preview, const ViewedPoints& points,
                                    const std::shared_ptr<const Environment>& environment, int samples) {
    Scene scene = points.scene;
    scene.environment.picture = environment;
    const std::vector<float> texels = preview.picture(scene, {points.side, points.side}, 1, true, samples);
    std::vector<glm::dvec3> values;
    for (const glm::ivec2& pixel : points.pixels) {
        const auto first =
            static_cast<std::size_t>(((points.side - 1 - pixel.y) * points.side + pixel.x) * 4);
        values.emplace_back(texels[first], texels[first + 1], texels[first + 2]);
    }
    return values;
}

double relative_error(const std::vector<glm::dvec3>& values, const std::vector<glm::dvec3>& exact) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            squares += (values[i][c] - exact[i][c]) * (values[i][c] - exact[i][c]);
            sum += exact[i][c];
        }
    const double count = 3 * static_cast<double>(exact.size());
    return std::sqrt(squares / count) / (sum / count);
}

}  // namespace nacre::test
