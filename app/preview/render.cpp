#include "app/preview/render.h"

#include "core/bake/bake.h"

namespace nacre {

RenderedImage picture_of(Preview& preview, const Scene& scene, glm::ivec2 size, bool linear) {
    const std::vector<float> texels = preview.picture(scene, size, 2, linear);
    RenderedImage image{size, {}};
    image.rgb.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 3);
    for (int row = size.y - 1; row >= 0; --row)
        for (int column = 0; column < size.x; ++column)
            for (int channel = 0; channel < 3; ++channel)
                image.rgb.push_back(texels[static_cast<std::size_t>((row * size.x + column) * 4 + channel)]);
    return image;
}

RenderedImage render_design(const Design& design, const Scene& scene, glm::ivec2 size, bool linear,
                            std::stop_token stop, const std::function<void(double)>& progress) {
    BakeOptions options;
    options.albedo = scene.ambient;
    Preview preview;
    preview.set(bake(design, options, std::move(stop), progress));
    return picture_of(preview, scene, size, linear);
}

}  // namespace nacre
