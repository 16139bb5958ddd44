#include "core/formats/material_json.h"

#include "core/formats/json_numbers.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;

// One parameter of a model, as its list has it.
template <class T>
void add_parameter(const T& model, const NumberParameter<T>& parameter, Json& json) {
    json[std::string(parameter.text.table_key())] = model.*parameter.member;
}
template <class T>
void add_parameter(const T& model, const ColourParameter<T>& parameter, Json& json) {
    json[std::string(parameter.text.table_key())] = json_numbers(model.*parameter.member);
}
template <class T>
void add_parameter(const T& model, const TripleParameter<T>& parameter, Json& json) {
    json[std::string(parameter.text.table_key())] = json_numbers(model.*parameter.member);
}

template <class T, class Enum, std::size_t count>
void add_parameter(const T& model, const ChoiceParameter<T, Enum, count>& parameter, Json& json) {
    json[std::string(parameter.text.table_key())] =
        parameter.names.at(static_cast<std::size_t>(model.*parameter.member));
}
template <class T>
void add_parameter(const T& model, const ColourCurveParameter<T>& parameter, Json& json) {
    Json points = Json::array();
    for (const auto& [theta, colour] : model.*parameter.member)
        points.push_back({theta, colour.x, colour.y, colour.z});
    json[std::string(parameter.text.table_key())] = std::move(points);
}
template <class T, class Row>
void add_parameter(const T& model, const ListParameter<T, Row>& parameter, Json& json);
template <class T, class Set>
void add_parameter(const T& model, const KindParameter<T, Set>& parameter, Json& json);

template <class T>
void add_parameters(const T& model, Json& json) {
    visit_parameters<T>([&](const auto& parameter) { add_parameter(model, parameter, json); });
}

template <class Variant>
void add_model(std::string_view key, const Variant& value, Json& json) {
    json[std::string(key)] = kind_name(value);
    std::visit([&](const auto& model) { add_parameters(model, json); }, value);
}

template <class T, class Row>
void add_parameter(const T& model, const ListParameter<T, Row>& parameter, Json& json) {
    Json rows = Json::array();
    for (const Row& row : model.*parameter.member) {
        rows.push_back(Json::object());
        add_parameters(row, rows.back());
    }
    json[std::string(parameter.text.table_key())] = std::move(rows);
}
template <class T, class Set>
void add_parameter(const T& model, const KindParameter<T, Set>& parameter, Json& json) {
    add_model(parameter.text.table_key(), model.*parameter.member, json);
}

Json curve_json(const FresnelCurve& curve) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < curve.values.size(); i += 3)
        rows.push_back({curve.values[i], curve.values[i + 1], curve.values[i + 2]});
    return rows;
}

}  // namespace

bool has_intensity(const Design& design) { return design.specular != Specular{}; }

bool is_retro(const Design& design) { return design.retro.weight > 0; }

Json material_json(const Design& design, const Tables& tables) {
    const auto& surface = tables.shading.surface;
    Json json;
    add_model("fresnel", beneath(design.fresnel, index_above(design.coat)), json);
    if (tables.shading.fresnel_curve) json["fresnel_curve"] = curve_json(*tables.shading.fresnel_curve);
    add_model("shadowing", design.shadowing.model, json);
    json["clamp"] = design.shadowing.clamp;
    add_model("diffuse", design.diffuse, json);
    if (!std::holds_alternative<NoDiffuse>(design.diffuse))
        json["diffuse_albedo"] = json_numbers(surface.albedo);
    if (tables.bounces) add_model("multibounce", design.multibounce, json);
    if (tables.needs.albedo) json["coupling"] = json_numbers(surface.coupling);
    if (has_intensity(design)) json["specular_intensity"] = design.specular.intensity;
    if (is_retro(design)) json["retro"] = design.retro.weight;
    if (is_coated(design.coat)) add_model("coat", design.coat, json);
    if (tables.needs.tint == Tint::shared) json["tint"] = json_numbers(tables.shading.layers[0].tint);
    return json;
}

}  // namespace nacre
