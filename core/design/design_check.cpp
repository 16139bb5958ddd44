#include "core/design/design_check.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/error.h"

namespace nacre {
namespace {

bool is_whole_sphere(const Layer& layer) {
    const auto* const uniform = std::get_if<UniformLobe>(&layer.lobe);
    const bool modulated = layer.modulation && layer.modulation->strength > 0;
    return uniform && uniform->domain == UniformDomain::sphere && !modulated;
}

template <class Variant>
void check_kind(const Variant& kind, std::string path, const std::string& file) {
    const std::optional<KindFault> fault = kind_fault(kind);
    if (!fault) return;
    if (!fault->key.empty()) path += fmt::format(".{}", fault->key);
    throw UserError(file, path, fault->problem, fault->found);
}

void check_layer(const Layer& layer, const std::string& path, const std::string& file) {
    check_kind(layer.lobe, path, file);
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

void check_bounces(const Design& design, const std::string& file) {
    const std::string problem = has_bounces(design.multibounce) ? bounce_problem(design) : "";
    if (!problem.empty())
        throw UserError(file, "multibounce.model", problem + ": only \"none\" is allowed",
                        std::string(kind_name(design.multibounce)));
}

}  // namespace

void check_design(const Design& design, const std::string& file) {
    check_layers(design.distribution.layers, file);
    check_kind(design.shadowing.model, "shadowing", file);
    check_kind(design.fresnel, "fresnel", file);
    check_kind(design.diffuse, "diffuse", file);
    check_bounces(design, file);
}

std::string bounce_problem(const Design& design) {
    if (!design.shadowing.clamp)
        return "without clamp R may exceed 1, which leaves bounces nothing to share out";
    if (std::holds_alternative<MetalDiffuse>(design.diffuse))
        return "the diffuse model \"metal\" stands for the same light";
    return "";
}

std::string energy_note(double intensity) {
    return intensity > 1 ? fmt::format("specular intensity {:g} creates energy", intensity) : "";
}

}  // namespace nacre
