#include "app/preview/render.h"

#include "app/preview/preview.h"
#include "core/bake/bake.h"

namespace nacre {

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
    const std::vector<float> texels = preview.picture(scene, size, 2, linear, samples, [&](double done) {
        report(bake_part + (1 - bake_part) * done);
        return !stop.stop_requested();
    });
    if (stop.stop_requested()) throw BakeCancelled();
    RenderedImage image{size, {}};
    image.rgb.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 3);
    for (int row = size.y - 1; row >= 0; --row)
        for (int column = 0; column < size.x; ++column)
            for (int channel = 0; channel < 3; ++channel)
                image.rgb.push_back(texels[static_cast<std::size_t>((row * size.x + column) * 4 + channel)]);
    return image;
}

}  // namespace nacre
