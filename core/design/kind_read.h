// Reads kinds, and their parameters by the list that each kind gives of them.
#pragma once

#include <fmt/core.h>

#include <filesystem>

#include "core/base/json_reader.h"
#include "core/model/kinds/kind.h"

namespace nacre {

// A raster held in the design, or the path of a picture file relative to `base_dir`.
Picture read_picture(const JsonValue& json, const std::filesystem::path& base_dir);

namespace kind_detail {

// A missing member keeps its default.
template <class T>
void read_parameter(ObjectReader& reader, T& kind, const NumberParameter<T>& parameter) {
    double& value = kind.*parameter.member;
    if (parameter.may_be_infinite)
        reader.number_or_infinity(parameter.text.key, value, parameter.bounds);
    else
        reader.number(parameter.text.key, value, parameter.bounds);
}

template <class T>
void read_parameter(ObjectReader& reader, T& kind, const ColourParameter<T>& parameter) {
    reader.colour(parameter.text.key, kind.*parameter.member, parameter.bounds);
}

template <class T>
void read_parameter(ObjectReader& reader, T& kind, const TripleParameter<T>& parameter) {
    reader.colour(parameter.text.key, kind.*parameter.member, parameter.bounds);
}

template <class T, class Enum, std::size_t count>
void read_parameter(ObjectReader& reader, T& kind, const ChoiceParameter<T, Enum, count>& parameter) {
    Enum& value = kind.*parameter.member;
    value = static_cast<Enum>(
        reader.choice(parameter.text.key, parameter.names, static_cast<std::size_t>(value)));
}

std::vector<std::pair<double, double>> read_curve(const JsonValue& json, Range theta, Range value,
                                                  int points_max);

std::vector<ColourPoint> read_colour_curve(const JsonValue& json, Range theta, Range value, int points_max);

template <class T>
void read_parameter(ObjectReader& reader, T& kind, const ColourCurveParameter<T>& parameter) {
    if (reader.has(parameter.text.key))
        kind.*parameter.member = read_colour_curve(reader.at(parameter.text.key), parameter.theta_bounds,
                                                   parameter.value_bounds, parameter.points_max);
}

template <class T>
void read_parameter(ObjectReader& reader, T& kind, const CurveParameter<T>& parameter) {
    if (reader.has(parameter.text.key))
        kind.*parameter.member = read_curve(reader.at(parameter.text.key), parameter.theta_bounds,
                                            parameter.value_bounds, parameter.points_max);
}

// Checks only that it is present: files are opened when nothing else is wrong.
template <class T>
void read_parameter(ObjectReader& reader, T&, const PictureParameter<T>& parameter) {
    reader.required(parameter.text.key, "a picture's path or a raster");
}

template <class T, class Row>
void read_parameter(ObjectReader& reader, T& kind, const ListParameter<T, Row>& parameter);
template <class T, class Set>
void read_parameter(ObjectReader& reader, T& kind, const KindParameter<T, Set>& parameter);

template <class T>
void read_parameters(ObjectReader& reader, T& kind) {
    visit_parameters<T>([&](const auto& parameter) { read_parameter(reader, kind, parameter); });
}

template <class T, class Row>
void read_parameter(ObjectReader& reader, T& kind, const ListParameter<T, Row>& parameter) {
    if (!reader.has(parameter.text.key)) return;
    const JsonValue json = reader.at(parameter.text.key);
    const std::string expected = fmt::format("must be a list of at most {} objects", parameter.rows_max);
    const std::vector<JsonValue> elements = json.elements(expected);
    if (elements.size() > static_cast<std::size_t>(parameter.rows_max)) json.fail(expected);
    std::vector<Row> rows(elements.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ObjectReader row(elements[i]);
        read_parameters(row, rows[i]);
        row.finish(fmt::format("a {}", Row::name));
    }
    kind.*parameter.member = std::move(rows);
}

// Throws a UserError that tells why where the name is not one of the set's.
std::size_t read_kind_name(ObjectReader& reader, std::string_view key,
                           std::span<const std::string_view> names, std::size_t otherwise,
                           const char* no_other);

template <class T, class Set>
void read_parameter(ObjectReader& reader, T& kind, const KindParameter<T, Set>& parameter) {
    Set& value = kind.*parameter.member;
    const std::size_t index =
        read_kind_name(reader, parameter.text.key, KindSet<Set>::names, value.index(), parameter.no_other);
    if (index != value.index()) value = KindSet<Set>::made(index);
    std::visit([&](auto& chosen) { read_parameters(reader, chosen); }, value);
}

template <class T, class Parameter>
void load_picture(const ObjectReader&, T&, const Parameter&, const std::filesystem::path&) {}

template <class T>
void load_picture(const ObjectReader& reader, T& kind, const PictureParameter<T>& parameter,
                  const std::filesystem::path& base_dir) {
    kind.*parameter.member = read_picture(reader.at(parameter.text.key), base_dir);
}

}  // namespace kind_detail

// The kind that `key` names, the first of the list where it is missing, with its parameters; pictures are
// left to load_pictures().
template <class Variant>
Variant read_kind(ObjectReader& reader, std::string_view key) {
    Variant value = KindSet<Variant>::made(reader.choice(key, KindSet<Variant>::names, 0));
    std::visit([&](auto& kind) { kind_detail::read_parameters(reader, kind); }, value);
    return value;
}

// The pictures among the parameters.
template <class Variant>
void load_pictures(const ObjectReader& reader, Variant& value, const std::filesystem::path& base_dir) {
    std::visit(
        [&]<class T>(T& kind) {
            visit_parameters<T>(
                [&](const auto& parameter) { kind_detail::load_picture(reader, kind, parameter, base_dir); });
        },
        value);
}

}  // namespace nacre
