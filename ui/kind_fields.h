// The fields of a kind's parameters, by the list that the kind gives of them, and the list of the kinds there
// are.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <variant>

#include "core/model/kinds/kind.h"
#include "ui/colour_curve.h"
#include "ui/curve_editor.h"
#include "ui/list_buttons.h"
#include "ui/picture_row.h"
#include "ui/widgets.h"

namespace nacre::ui {

namespace kind_detail {

inline SliderSpec slider_spec(const ParameterText& text, Range bounds, const SliderScale& scale) {
    return {.label = text.label,
            .low = scale.ends.low,
            .high = scale.ends.high,
            .least = bounds.low,
            .most = bounds.high,
            .reset = 0,
            .format = scale.format,
            .logarithmic = scale.logarithmic,
            .tooltip = text.tooltip};
}

// Each returns whether the parameter changed. Only curves need `curve`.
template <class T>
bool parameter_field(T& kind, const NumberParameter<T>& parameter, CurveView*) {
    SliderSpec spec = slider_spec(parameter.text, parameter.bounds, parameter.slider);
    spec.reset = T{}.*parameter.member;
    double& value = kind.*parameter.member;
    const bool changed = parameter.may_be_infinite ? slider_or_infinity(spec, value) : slider(spec, value);
    if constexpr (requires { kind.make_room(parameter.member); })
        if (changed) kind.make_room(parameter.member);
    return changed;
}

template <class T>
bool parameter_field(T& kind, const ColourParameter<T>& parameter, CurveView*) {
    return colour(parameter.text.label, kind.*parameter.member, T{}.*parameter.member,
                  parameter.text.tooltip);
}

template <class T>
bool parameter_field(T& kind, const TripleParameter<T>& parameter, CurveView*) {
    return slider(slider_spec(parameter.text, parameter.bounds, parameter.slider), kind.*parameter.member,
                  T{}.*parameter.member);
}

template <class T, class Enum, std::size_t count>
bool parameter_field(T& kind, const ChoiceParameter<T, Enum, count>& parameter, CurveView*) {
    int index = static_cast<int>(kind.*parameter.member);
    const bool changed =
        combo(parameter.text.label, index, parameter.labels, parameter.text.tooltip, {}, parameter.swatch);
    if (changed) kind.*parameter.member = static_cast<Enum>(index);
    return changed;
}

template <class T>
bool parameter_field(T& kind, const CurveParameter<T>&, CurveView* curve) {
    return curve && curve_editor(*curve, kind);
}

template <class Row>
bool row_fields(Row& row, std::size_t place) {
    bool changed = false;
    visit_parameters<Row>([&](const auto& number) {
        const std::string label = fmt::format("{} {}", number.text.label, place);
        SliderSpec spec = slider_spec(number.text, number.bounds, number.slider);
        spec.label = label.c_str();
        spec.reset = Row{}.*number.member;
        changed |= slider(spec, row.*number.member);
    });
    return changed;
}

// Rows of numbers, each by its place in the list, with buttons to add and remove one. What would break a rule
// of the kind is taken back and said.
template <class T, class Row>
bool parameter_field(T& kind, const ListParameter<T, Row>& parameter, CurveView*) {
    const T before = kind;
    auto& rows = kind.*parameter.member;
    bool changed = false;
    for (std::size_t i = 0; i < rows.size(); ++i) changed |= row_fields(rows[i], i + 1);
    changed |= list_buttons(rows, 0, static_cast<std::size_t>(parameter.rows_max), parameter.text, Row::name,
                            [] { return Row{}; });
    const std::optional<KindFault> fault = kind_fault(std::variant<T>(kind));
    if (!fault) return changed;
    kind = before;
    warning_text(fmt::format("{} ({})", fault->problem, fault->found));
    return false;
}

template <class T>
bool parameter_field(T& kind, const ColourCurveParameter<T>& parameter, CurveView*) {
    return colour_curve_fields(kind.*parameter.member, parameter.text, parameter.theta_bounds,
                               static_cast<std::size_t>(parameter.points_max));
}

template <class T>
bool parameter_field(T& kind, const PictureParameter<T>& parameter, CurveView*) {
    picture_row(parameter.text.label, kind.*parameter.member);
    return false;
}

template <class T, class Set>
bool parameter_field(T& kind, const KindParameter<T, Set>& parameter, CurveView* curve);

}  // namespace kind_detail

// Each returns whether a parameter changed.
template <class T>
bool part_fields(T& kind, CurveView* curve = nullptr) {
    bool changed = false;
    visit_parameters<T>(
        [&](const auto& parameter) { changed |= kind_detail::parameter_field(kind, parameter, curve); });
    return changed;
}

template <class Variant>
bool kind_fields(Variant& value, CurveView* curve = nullptr) {
    bool changed = false;
    std::visit(
        [&]<class T>(T& kind) {
            changed |= part_fields(kind, curve);
            if constexpr (requires { T::note; })
                if (T::note[0] != '\0') dim_text(T::note);
        },
        value);
    return changed;
}

// The list of the kinds there are; its tooltip is `about` and what the chosen kind says of itself.
// `convert.template operator()<T>()` makes the kind that is chosen of the one before.
template <class Variant, class Convert>
bool kind_combo(const char* label, Variant& value, const std::string& about, const Convert& convert) {
    using Set = KindSet<Variant>;
    int index = static_cast<int>(value.index());
    const std::string tooltip =
        about + (about.empty() ? "" : "\n") + kind_label(value) + ": " + Set::explanations[value.index()];
    if (!combo(label, index, Set::labels, tooltip.c_str(), Set::explanations)) return false;
    value = KindSet<Variant>::made_by(static_cast<std::size_t>(index), convert);
    return true;
}

namespace kind_detail {

template <class T, class Set>
bool parameter_field(T& kind, const KindParameter<T, Set>& parameter, CurveView* curve) {
    Set& value = kind.*parameter.member;
    const bool chosen =
        kind_combo(parameter.text.label, value, parameter.text.tooltip, []<class Made>() { return Made{}; });
    return kind_fields(value, curve) || chosen;
}

}  // namespace kind_detail

}  // namespace nacre::ui
