#include "app/preview/render.h"

#include "core/bake/bake.h"

namespace nacre {
namespace {

constexpr int supersample = 2;

// From four channels and the bottom row first.
std::vector<float> upright(const std::vector<float>& texels, glm::ivec2 size) {
    std::vector<float> rgb;
    rgb.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 3);
    for (int row = size.y - 1; row >= 0; --row)
        for (int column = 0; column < size.x; ++column)
            for (int channel = 0; channel < 3; ++channel)
                rgb.push_back(texels[static_cast<std::size_t>((row * size.x + column) * 4 + channel)]);
    return rgb;
}

}  // namespace

RenderedImage picture_of(Preview& preview, const Scene& scene, glm::ivec2 size, bool linear) {
    return {size, upright(preview.picture(scene, size, supersample, linear, usual_samples), size)};
}

RenderedImage render_design(const Design& design, const Scene& scene, glm::ivec2 size, bool linear,
                            std::stop_token stop, const std::function<void(double)>& progress, int samples) {
    BakeOptions options;
    options.albedo = scene.ambient;
    Preview preview;
    const double bake_part = scene.environment.picture ? 0.1 : 1;
    const auto report = [&](double done) {
        if (progress) progress(done);
    };
    preview.set(bake(design, options, stop, [&](double done) { report(bake_part * done); }));
    const std::vector<float> texels =
        preview.picture(scene, size, supersample, linear, samples, [&](double done) {
            report(bake_part + (1 - bake_part) * done);
            return !stop.stop_requested();
        });
    if (stop.stop_requested()) throw BakeCancelled();
    return {size, upright(texels, size)};
}

RenderedPair render_pair(const ComparedSurface& left, const ComparedSurface& right, const Scene& scene,
                         glm::ivec2 size, bool linear, int samples) {
    Preview a, b;
    a.set(left.tables, left.model);
    b.set(right.tables, right.model);
    if (is_factor(scene.term)) {
        const FactorScale scale = common_scale(a.scale(scene), b.scale(scene));
        a.use_scale(scale);
        b.use_scale(scale);
    }
    RenderedPair pair;
    pair.left = {size, upright(a.picture(scene, size, supersample, linear, samples), size)};
    pair.right = {size, upright(b.picture(scene, size, supersample, linear, samples), size)};
    pair.left_radiance = upright(a.numbers(), size);
    pair.right_radiance = upright(b.numbers(), size);
    const SurfaceImage& object = a.surface(scene, size);
    pair.difference = measure_difference(pair.left_radiance, pair.right_radiance, 3, [&](std::size_t pixel) {
        const auto width = static_cast<std::size_t>(size.x);
        return object.covered({static_cast<int>(pixel % width), static_cast<int>(pixel / width)});
    });
    return pair;
}

}  // namespace nacre
