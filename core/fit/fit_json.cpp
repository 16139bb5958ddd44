#include "core/fit/fit_json.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace nacre {

namespace {

using Json = nlohmann::ordered_json;

// Six digits: more than a fit is worth.
double short_number(double value) { return std::stod(fmt::format("{:.6g}", value)); }

Json json_of(const MixtureLobe& lobe) {
    Json json = {{"weight", short_number(lobe.weight)},   {"alpha_x", short_number(lobe.alpha_x)},
                 {"alpha_y", short_number(lobe.alpha_y)}, {"rotation", short_number(lobe.rotation)},
                 {"tilt", short_number(lobe.tilt)},       {"azimuth", short_number(lobe.azimuth)}};
    if (lobe.tile.empty()) return json;
    Json tile = Json::array();
    for (const float value : lobe.tile) tile.push_back(short_number(static_cast<double>(value)));
    json["tile"] = std::move(tile);
    return json;
}

std::string_view formula_of(FitTarget target) {
    return target == FitTarget::cycles
               ? "sum of weight D(h)/(4 (N.v) (n.l) (1 + Lambda(v) + Lambda(l))), N the lobe's normal"
               : "sum of weight D(h)/(4 (n.v) (n.l) (1 + Lambda(v) + Lambda(l)))";
}

}  // namespace

std::string_view name_of(LobeShape shape) { return shape == LobeShape::ggx ? "ggx" : "beckmann"; }

std::string_view name_of(LobeWeights weights) { return weights == LobeWeights::view ? "view" : "constant"; }

std::string_view name_of(FitTarget target) { return target == FitTarget::cycles ? "cycles" : "standard"; }

// A line for each lobe: a tile is too many numbers to have a line for each.
std::string fit_json(const LobeFit& fit) {
    Json json = {{"nacre", "lobes"},
                 {"version", 1},
                 {"target", name_of(fit.target)},
                 {"brdf", formula_of(fit.target)},
                 {"family", name_of(fit.mixture.shape)},
                 {"weights", name_of(fit.mixture.weights)},
                 {"misplaced", short_number(fit.misplaced)}};
    if (fit.mixture.weights == LobeWeights::view) json["tile_side"] = tile_side;
    std::string text = "{\n";
    for (const auto& [key, value] : json.items()) text += fmt::format("  \"{}\": {},\n", key, value.dump());
    text += "  \"lobes\": [";
    for (const MixtureLobe& lobe : fit.mixture.lobes)
        text +=
            fmt::format("{}\n    {}", &lobe == &fit.mixture.lobes.front() ? "" : ",", json_of(lobe).dump());
    return text + "\n  ]\n}\n";
}

}  // namespace nacre
