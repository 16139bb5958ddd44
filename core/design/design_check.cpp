#include "core/design/design_check.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/design/error.h"

namespace nacre {
namespace {

bool counts(const Layer& layer) { return layer.enabled && layer.weight > 0; }

bool is_black(const Picture& picture) {
    const std::vector<float>& values = picture.raster->values;
    return std::none_of(values.begin(), values.end(), [](float value) { return value > 0; });
}

bool is_whole_sphere(const Layer& layer) {
    const auto* const uniform = std::get_if<UniformLobe>(&layer.lobe);
    const bool modulated = layer.modulation && layer.modulation->strength > 0;
    return uniform && uniform->domain == UniformDomain::sphere && !modulated;
}

void check_layer(const Layer& layer, const std::string& path, const std::string& file) {
    const auto* const painted = std::get_if<PaintedLobe>(&layer.lobe);
    if (painted && is_black(painted->image))
        throw UserError(file, path + ".image", "the picture needs a pixel above 0", "all black: no facets");
    if (layer.modulation && layer.modulation->strength == 1 && is_black(layer.modulation->image))
        throw UserError(file, path + ".modulation.image", "at strength 1 the picture needs a pixel above 0",
                        "all black: no facets");
}

void check_layers(const std::vector<Layer>& layers, const std::string& file) {
    const std::string path = "distribution.layers";
    const auto enabled =
        std::count_if(layers.begin(), layers.end(), [](const Layer& l) { return l.enabled; });
    const auto counting = std::count_if(layers.begin(), layers.end(), counts);
    if (counting == 0)
        throw UserError(file, path, "one enabled layer at least needs a weight above 0",
                        layers.empty() ? "no layer"
                        : enabled == 0 ? "no enabled layer"
                                       : "every enabled weight is 0");
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (counts(layers[i])) check_layer(layers[i], fmt::format("{}[{}]", path, i), file);
    const auto sphere = [](const Layer& layer) { return !counts(layer) || is_whole_sphere(layer); };
    if (std::all_of(layers.begin(), layers.end(), sphere))
        throw UserError(file, path, "the facets must face up on the whole, N = <n.h> above 0",
                        "uniform over the whole sphere alone: N = 0");
}

}  // namespace

void check_design(const Design& design, const std::string& file) {
    check_layers(design.distribution.layers, file);
    constexpr double rounding = 1e-9;
    const auto* const diffuse = std::get_if<LambertianDiffuse>(&design.diffuse);
    if (diffuse && diffuse->kd + diffuse->ks > 1 + rounding)
        throw UserError(file, "diffuse", "kd + ks must not exceed 1, or energy is created",
                        fmt::format("{} + {} = {}", diffuse->kd, diffuse->ks, diffuse->kd + diffuse->ks));
}

}  // namespace nacre
