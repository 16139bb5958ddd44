#include "core/model/tint.h"

#include <algorithm>

#include "core/model/layer.h"

namespace nacre {

Tint tint_of(const Distribution& distribution) {
    const glm::dvec3* first = nullptr;
    for (const Layer& layer : distribution.layers) {
        if (!counts(layer)) continue;
        if (!first) first = &layer.tint;
        if (layer.tint != *first) return Tint::varied;
    }
    return !first || *first == glm::dvec3{1} ? Tint::none : Tint::shared;
}

glm::dvec3 mean_tint(const Distribution& distribution) {
    const Layer* first = nullptr;
    double largest = 0;
    for (const Layer& layer : distribution.layers) {
        if (!counts(layer)) continue;
        if (!first) first = &layer;
        largest = std::max(largest, layer.weight);
    }
    if (!first) return glm::dvec3{1};
    if (tint_of(distribution) != Tint::varied) return first->tint;
    // Of the largest weight first, as in FacetDistribution.
    glm::dvec3 sum{0};
    double whole = 0;
    for (const Layer& layer : distribution.layers) {
        if (!counts(layer)) continue;
        const double share = layer.weight / largest;
        sum += share * layer.tint;
        whole += share;
    }
    return sum / whole;
}

}  // namespace nacre
