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

double width() { return std::clamp(std::exp(number(-11.6, 11.6)), limits::width_min, limits::width_max); }

double width_or_infinity() { return integer(0, 4) == 0 ? limits::infinity : width(); }

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

CurveLobe random_curve() {
    CurveLobe curve{{{0, 1}}};
    for (int i = integer(1, 5); i > 0; --i)
        curve.points.emplace_back(std::min(curve.points.back().first + number(1e-3, 30), 180.0),
                                  number(0, 1e30));
    return curve;
}

Lobe random_lobe(const std::vector<Picture>& files) {
    switch (integer(0, 6)) {
        case 0:
            return GaussianLobe{width_or_infinity(), width_or_infinity()};
        case 1:
            return InverseGaussianLobe{width()};
        case 2:
            return GgxLobe{width(), width()};
        case 3:
            return BeckmannLobe{width(), width()};
        case 4:
            return UniformLobe{coin() ? UniformDomain::hemisphere : UniformDomain::sphere};
        case 5:
            return random_curve();
        default:
            return PaintedLobe{random_picture(files)};
    }
}

Layer random_layer(const std::vector<Picture>& files) {
    Layer layer{
        text(), coin(), random_lobe(files), weight(), number(-360, 360), number(0, 180), number(-360, 360),
        {}};
    if (coin()) layer.modulation = Modulation{random_picture(files), number(0, 1)};
    return layer;
}

Fresnel random_fresnel() {
    switch (integer(0, 3)) {
        case 0:
            return SchlickFresnel{colour(0, 1)};
        case 1:
            return DielectricFresnel{number(limits::ior_min, limits::ior_max)};
        case 2:
            return ConductorFresnel{colour(limits::eta_min, limits::eta_max), colour(0, limits::k_max)};
        default:
            return NoFresnel{};
    }
}

Diffuse random_diffuse() {
    const double kd = number(0, 1);
    switch (integer(0, 3)) {
        case 0:
            return LambertianDiffuse{kd, number(0, 1 - kd), colour(0, 1)};
        case 1:
            return CoupledDiffuse{colour(0, 1)};
        case 2:
            return MetalDiffuse{};
        default:
            return NoDiffuse{};
    }
}

}  // namespace

Design random_design(const std::vector<Picture>& files) {
    Design design;
    design.name = text();
    design.note = text();
    for (int i = integer(0, 4); i > 0; --i) design.distribution.layers.push_back(random_layer(files));
    design.distribution.mean_cosine_scale =
        number(limits::mean_cosine_scale_min, limits::mean_cosine_scale_max);
    design.shadowing.model = static_cast<ShadowingModel>(integer(0, 2));
    if (design.shadowing.model == ShadowingModel::correlated) design.shadowing.width = number(0.1, 180);
    design.shadowing.clamp = coin();
    design.fresnel = random_fresnel();
    design.diffuse = random_diffuse();
    return design;
}

}  // namespace nacre::test
