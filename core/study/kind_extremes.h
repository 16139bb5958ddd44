// The extreme values of every kind of a set, from its list of parameters: all of a kind's parameters together
// from one end of their bounds to the other, each by itself at either end with the others as the kind comes,
// and every second one at one end with the rest at the other. Extremes within the bounds are added by
// the kind's singular().
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/model/kinds/kind.h"
#include "core/model/lobes/widths.h"

namespace nacre {

template <class T>
struct NamedValue {
    std::string name;
    T value;
};

// A picture from a function of the texel's column and row.
template <class Function>
Picture picture_of_texels(int side, const Function& value) {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = side;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            raster->values.push_back(static_cast<float>(value(column, row)));
    return {{}, std::move(raster)};
}

inline Picture checkerboard(int side) {
    return picture_of_texels(side, [](int column, int row) { return (column + row) % 2; });
}

namespace extremes_detail {

// Those choices of a list: all of a few, the first and the last of many.
inline std::vector<std::size_t> listed(std::size_t count) {
    if (count > 4) return {0, count - 1};
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(i);
    return all;
}

// One value of a parameter, and how it is called.
template <class T>
struct Setting {
    std::string text;
    std::function<void(T&)> apply;
};

template <class T>
using Settings = std::vector<Setting<T>>;

template <class T, class Value>
Setting<T> setting(std::string text, Value T::*member, const Value& value) {
    return {std::move(text), [member, value](T& kind) { kind.*member = value; }};
}

// Each parameter's values, from the lowest to the highest: the ends of its bounds, on a logarithmic scale
// every power of 100 between them, and infinity.
template <class T>
Settings<T> settings_of(const NumberParameter<T>& parameter) {
    const auto [low, high] = parameter.bounds;
    std::vector<double> values = {low};
    if (parameter.slider.logarithmic)
        for (int power = 2 * static_cast<int>(std::floor(std::log10(low) / 2)) + 2;
             std::pow(10, power) < high; power += 2)
            values.push_back(std::pow(10, power));
    values.push_back(high);
    if (parameter.may_be_infinite) values.push_back(limits::infinity);
    Settings<T> settings;
    for (const double value : values)
        settings.push_back(setting(fmt::format("{:g}", value), parameter.member, value));
    return settings;
}

// Of three numbers: all at either end, and one at each end with one between them.
template <class T>
Settings<T> settings_of_three(glm::dvec3 T::*member, Range bounds, double middle) {
    const auto [low, high] = bounds;
    return {
        setting(fmt::format("{:g}", low), member, glm::dvec3(low)),
        setting(fmt::format("({:g}, {:g}, {:g})", low, middle, high), member, glm::dvec3(low, middle, high)),
        setting(fmt::format("{:g}", high), member, glm::dvec3(high))};
}

template <class T>
Settings<T> settings_of(const ColourParameter<T>& parameter) {
    const Range bounds = parameter.bounds;
    return settings_of_three(parameter.member, bounds, (bounds.low + bounds.high) / 2);
}

template <class T>
Settings<T> settings_of(const TripleParameter<T>& parameter) {
    const Range bounds = parameter.bounds;
    const double middle =
        parameter.slider.logarithmic ? std::sqrt(bounds.low * bounds.high) : (bounds.low + bounds.high) / 2;
    return settings_of_three(parameter.member, bounds, middle);
}

template <class T, class Enum, std::size_t count>
Settings<T> settings_of(const ChoiceParameter<T, Enum, count>& parameter) {
    Settings<T> settings;
    for (const std::size_t i : listed(count))
        settings.push_back(setting(std::string(parameter.names[i]), parameter.member, static_cast<Enum>(i)));
    return settings;
}

// Empty, and as long as it may be with rows at either end of their bounds.
template <class T, class Row>
Settings<T> settings_of(const ListParameter<T, Row>& parameter) {
    Row low, high;
    visit_parameters<Row>([&](const auto& number) {
        low.*number.member = number.bounds.low;
        high.*number.member = number.bounds.high;
    });
    const auto size = static_cast<std::size_t>(parameter.rows_max);
    return {setting("none", parameter.member, std::vector<Row>{}),
            setting("all low", parameter.member, std::vector<Row>(size, low)),
            setting("one high", parameter.member, std::vector<Row>{high})};
}

template <class T>
Settings<T> settings_of(const ColourCurveParameter<T>& parameter) {
    const auto [low, high] = parameter.value_bounds;
    const auto [begin, end] = parameter.theta_bounds;
    using Points = std::vector<ColourPoint>;
    return {setting("lowest", parameter.member, Points{{begin, glm::dvec3(low)}}),
            setting("highest to lowest", parameter.member,
                    Points{{begin, glm::dvec3(high)}, {end, glm::dvec3(low)}}),
            setting("highest", parameter.member, Points{{begin, glm::dvec3(high)}})};
}

// Each kind of the other set as it comes.
template <class T, class Set>
Settings<T> settings_of(const KindParameter<T, Set>& parameter) {
    Settings<T> settings;
    for (std::size_t i = 0; i < KindSet<Set>::count; ++i)
        settings.push_back(
            setting(std::string(KindSet<Set>::names[i]), parameter.member, KindSet<Set>::made(i)));
    return settings;
}

template <class T>
Settings<T> settings_of(const CurveParameter<T>& parameter) {
    const auto [low, high] = parameter.theta_bounds;
    const double some = std::min(parameter.value_bounds.high, 1.0);
    const double near = low + (high - low) / 1800;
    using Points = std::vector<std::pair<double, double>>;
    return {
        setting(fmt::format("straight to 0 at {:g}", near), parameter.member, Points{{low, some}, {near, 0}}),
        setting("from end to end", parameter.member, Points{{low, some}, {high, some / 5}})};
}

template <class T>
Settings<T> settings_of(const PictureParameter<T>& parameter) {
    return {setting("of one texel", parameter.member, picture_of_texels(1, [](int, int) { return 1; })),
            setting("of a checkerboard", parameter.member, checkerboard(64))};
}

template <Kind T>
class KindExtremes {
  public:
    std::vector<NamedValue<T>> all() {
        visit_parameters<T>([&](const auto& parameter) {
            keys_.emplace_back(parameter.text.key);
            settings_.push_back(settings_of(parameter));
        });
        if (settings_.empty()) add({});
        add_together();
        add_each();
        add_opposed();
        if constexpr (requires { T::singular(); })
            for (const auto& [name, value] : T::singular()) add(fmt::format("{}, {}", T::name, name), value);
        return std::move(extremes_);
    }

  private:
    // Null for a parameter that stays as the kind comes.
    using Chosen = std::vector<const Setting<T>*>;

    void add_together() {
        std::size_t most = 0;
        for (const Settings<T>& settings : settings_) most = std::max(most, settings.size());
        for (std::size_t level = 0; level < most; ++level) {
            Chosen chosen;
            for (const Settings<T>& settings : settings_)
                chosen.push_back(&settings[std::min(level, settings.size() - 1)]);
            add(chosen);
        }
    }

    void add_each() {
        for (std::size_t i = 0; i < settings_.size(); ++i)
            for (const Setting<T>* end : {&settings_[i].front(), &settings_[i].back()}) {
                Chosen chosen(settings_.size());
                chosen[i] = end;
                add(chosen);
            }
    }

    void add_opposed() {
        for (const std::size_t odd : {0, 1}) {
            Chosen chosen;
            for (std::size_t i = 0; i < settings_.size(); ++i)
                chosen.push_back((i + odd) % 2 == 0 ? &settings_[i].front() : &settings_[i].back());
            add(chosen);
        }
    }

    void add(const Chosen& chosen) {
        T kind = as_it_comes();
        std::vector<std::string> texts, words;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (!chosen[i]) continue;
            chosen[i]->apply(kind);
            texts.push_back(chosen[i]->text);
            words.push_back(fmt::format("{} {}", keys_[i], chosen[i]->text));
        }
        std::string name(T::name);
        const bool same =
            texts.size() == chosen.size() &&
            std::adjacent_find(texts.begin(), texts.end(), std::not_equal_to<>{}) == texts.end();
        if (!texts.empty()) name += " " + (same ? texts.front() : fmt::format("{}", fmt::join(words, ", ")));
        add(std::move(name), kind);
    }

    // Nothing twice, and nothing that breaks a rule of the kind.
    void add(std::string name, const T& kind) {
        if (kind_fault(std::variant<T>(kind))) return;
        const auto is_same = [&](const NamedValue<T>& other) { return other.value == kind; };
        if (std::any_of(extremes_.begin(), extremes_.end(), is_same)) return;
        extremes_.push_back({std::move(name), kind});
    }

    static T as_it_comes() {
        if constexpr (requires { T::of_widths(glm::dvec2(default_width)); })
            return T::of_widths(glm::dvec2(default_width));
        else
            return T{};
    }

    std::vector<std::string> keys_;
    std::vector<Settings<T>> settings_;
    std::vector<NamedValue<T>> extremes_;
};

}  // namespace extremes_detail

// Every extreme value of every kind of a set, no value of a kind twice.
template <class Variant>
std::vector<NamedValue<Variant>> extreme_kinds() {
    std::vector<NamedValue<Variant>> all;
    KindSet<Variant>::each([&]<class T>() {
        for (NamedValue<T>& extreme : extremes_detail::KindExtremes<T>().all())
            all.push_back({std::move(extreme.name), std::move(extreme.value)});
        return 0;
    });
    return all;
}

}  // namespace nacre
