#include "tests/core/random_design.h"

#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace nacre::test {
namespace {

int integer(int low, int high) { return *rc::gen::inRange(low, high + 1); }

bool coin() { return integer(0, 1) == 1; }

// A double with all its digits, now and then one of the bounds.
double number(double low, double high) {
    const auto fraction = static_cast<double>(*rc::gen::inRange<std::uint64_t>(0, 1ull << 53)) / 0x1p53;
    const int special = integer(0, 9);
    return special == 0 ? low : special == 1 ? high : std::clamp(low + (high - low) * fraction, low, high);
}

double weight() { return std::min(std::exp(number(-30, 70)), limits::weight_max); }

glm::dvec3 colour(double low, double high) {
    return {number(low, high), number(low, high), number(low, high)};
}

std::string text() {
    constexpr const char* pieces[] = {"Satin", " ", "\"", "\\", "\n",   "\t", "é",
                                      "漢字",  "🐚", "/",  "{",  "\x01", "'"};
    std::string all;
    for (int i = integer(0, 6); i > 0; --i) all += pieces[integer(0, int(std::size(pieces)) - 1)];
    return all;
}

// Any finite float that is no less than 0, subnormal ones among them.
float pixel() { return std::bit_cast<float>(*rc::gen::inRange<std::uint32_t>(0, 0x7F800000u)); }

Picture random_picture(const std::vector<Picture>& files) {
    if (coin()) return files[static_cast<std::size_t>(integer(0, int(files.size()) - 1))];
    Raster raster;
    raster.width = raster.height = integer(1, 4);
    for (int i = 0; i < raster.width * raster.height; ++i) raster.values.push_back(pixel());
    raster.values.back() = 0.1f;
    return {{}, std::make_shared<const Raster>(raster)};
}

// A random value of each parameter that a kind lists, within its bounds.
struct RandomParameter {
    const std::vector<Picture>& files;

    template <class T>
    void operator()(T& kind, const NumberParameter<T>& parameter) const {
        const Range bounds = parameter.bounds;
        double& value = kind.*parameter.member;
        if (parameter.may_be_infinite && integer(0, 4) == 0)
            value = limits::infinity;
        else if (parameter.slider.logarithmic)
            value = std::clamp(std::exp(number(std::log(bounds.low), std::log(bounds.high))), bounds.low,
                               bounds.high);
        else
            value = number(bounds.low, bounds.high);
        if constexpr (requires { kind.make_room(parameter.member); }) kind.make_room(parameter.member);
    }
    template <class T>
    void operator()(T& kind, const ColourParameter<T>& parameter) const {
        kind.*parameter.member = colour(parameter.bounds.low, parameter.bounds.high);
    }
    template <class T>
    void operator()(T& kind, const TripleParameter<T>& parameter) const {
        kind.*parameter.member = colour(parameter.bounds.low, parameter.bounds.high);
    }
    template <class T, class Enum, std::size_t count>
    void operator()(T& kind, const ChoiceParameter<T, Enum, count>& parameter) const {
        kind.*parameter.member = static_cast<Enum>(integer(0, static_cast<int>(count) - 1));
    }
    template <class T>
    void operator()(T& kind, const CurveParameter<T>& parameter) const {
        auto& points = kind.*parameter.member;
        points = {{parameter.theta_bounds.low, 1}};
        for (int i = integer(1, 5); i > 0; --i)
            points.emplace_back(std::min(points.back().first + number(1e-3, 30), parameter.theta_bounds.high),
                                number(parameter.value_bounds.low, parameter.value_bounds.high));
    }
    template <class T>
    void operator()(T& kind, const ColourCurveParameter<T>& parameter) const {
        const Range bounds = parameter.value_bounds;
        auto& points = kind.*parameter.member;
        points = {{parameter.theta_bounds.low, colour(bounds.low, bounds.high)}};
        for (int i = integer(0, 5); i > 0; --i)
            points.push_back({points.back().theta + number(1e-3, 15), colour(bounds.low, bounds.high)});
    }
    // Rules between a kind's parameters bound the sum of the rows: few of them.
    template <class T, class Row>
    void operator()(T& kind, const ListParameter<T, Row>& parameter) const {
        auto& rows = kind.*parameter.member;
        rows.resize(static_cast<std::size_t>(integer(0, std::min(parameter.rows_max, 3))));
        for (Row& row : rows) fill(row);
        if (kind_fault(std::variant<T>(kind))) rows.resize(1);
    }
    template <class T, class Set>
    void operator()(T& kind, const KindParameter<T, Set>& parameter) const {
        Set& value = kind.*parameter.member;
        value = KindSet<Set>::made(
            static_cast<std::size_t>(integer(0, static_cast<int>(KindSet<Set>::count) - 1)));
        std::visit([&](auto& chosen) { fill(chosen); }, value);
    }
    template <class T>
    void fill(T& kind) const {
        visit_parameters<T>([&](const auto& parameter) { (*this)(kind, parameter); });
    }
    template <class T>
    void operator()(T& kind, const PictureParameter<T>& parameter) const {
        kind.*parameter.member = random_picture(files);
    }
};

template <class Variant>
Variant random_kind(const std::vector<Picture>& files = {}) {
    Variant value = KindSet<Variant>::made(
        static_cast<std::size_t>(integer(0, static_cast<int>(KindSet<Variant>::count) - 1)));
    std::visit([&](auto& kind) { RandomParameter{files}.fill(kind); }, value);
    return value;
}

PictureSource random_source() {
    return {.image = "/pictures/source.png",
            .as = static_cast<SourceUse>(integer(0, 2)),
            .size = number(limits::stamp_size_min, limits::stamp_size_max),
            .reading = {coin(), coin(), coin()},
            .height = number(-limits::relief_max, limits::relief_max),
            .smoothing = number(0, limits::smoothing_max),
            .rotation = number(-360, 360),
            .flip = coin()};
}

Layer random_layer(const std::vector<Picture>& files) {
    Layer layer{text(),
                coin(),
                random_kind<Lobe>(files),
                weight(),
                number(-360, 360),
                number(0, 180),
                number(-360, 360),
                {}};
    if (coin()) layer.modulation = Modulation{random_picture(files), number(0, 1)};
    if (coin()) layer.tint = colour(0, 1);
    if (std::holds_alternative<PaintedLobe>(layer.lobe) && coin()) layer.source = random_source();
    return layer;
}

}  // namespace

Design random_design(const std::vector<Picture>& files) {
    Design design;
    design.name = text();
    design.note = text();
    for (int i = integer(0, 4); i > 0; --i) design.distribution.layers.push_back(random_layer(files));
    design.distribution.mean_cosine_scale =
        number(limits::mean_cosine_scale_min, limits::mean_cosine_scale_max);
    design.shadowing.model = random_kind<MaskingModel>();
    design.shadowing.clamp = coin();
    design.fresnel = random_kind<Fresnel>();
    design.diffuse = random_kind<Diffuse>();
    const bool may_bounce = design.shadowing.clamp && !std::holds_alternative<MetalDiffuse>(design.diffuse);
    if (may_bounce && coin()) design.multibounce = random_kind<Multibounce>();
    if (coin()) design.specular.intensity = number(0, limits::intensity_max);
    if (coin()) RandomParameter{files}.fill(design.retro);
    if (coin()) design.coat = random_kind<Coat>();
    return design;
}

}  // namespace nacre::test
