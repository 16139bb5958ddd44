// Measured materials: the warp and its inverse, the file as another reader has it, and the error it claims.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/formats/rgl_file.h"
#include "core/formats/rgl_place.h"
#include "core/formats/rgl_tables.h"
#include "core/formats/tensor_file.h"
#include "core/image/luminance.h"
#include "core/model/spectral/primary_spectra.h"
#include "core/model/spectral/spectral_colour.h"
#include "tests/core/cheap.h"

using namespace nacre;
using namespace nacre::test;

namespace {

SquareDensity random_density(glm::ivec2 size, Random& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> values;
    for (int i = 0; i < size.x * size.y; ++i) values.push_back(std::pow(uniform(random), 4));
    return {size, std::move(values)};
}

// A number of an unsigned type at a place of the bytes, which moves on.
template <class T>
T take(const std::string& bytes, std::size_t& at) {
    T value;
    REQUIRE(at + sizeof value <= bytes.size());
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

struct Field {
    int type;
    std::size_t offset;
    std::vector<std::size_t> shape;
};

// As the format's description has it.
std::map<std::string, Field> fields_of(const std::string& bytes) {
    std::size_t at = 12;
    REQUIRE(bytes.substr(0, 12) == std::string("tensor_file\0", 12));
    REQUIRE(take<std::uint8_t>(bytes, at) == 1);
    REQUIRE(take<std::uint8_t>(bytes, at) == 0);
    const auto count = take<std::uint32_t>(bytes, at);
    std::map<std::string, Field> fields;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto length = take<std::uint16_t>(bytes, at);
        const std::string name = bytes.substr(at, length);
        at += length;
        const auto dimensions = take<std::uint16_t>(bytes, at);
        Field field{
            take<std::uint8_t>(bytes, at), static_cast<std::size_t>(take<std::uint64_t>(bytes, at)), {}};
        std::size_t size = field.type == 10 ? 4 : 1;
        for (int d = 0; d < dimensions; ++d) {
            field.shape.push_back(static_cast<std::size_t>(take<std::uint64_t>(bytes, at)));
            size *= field.shape.back();
        }
        CHECK(field.offset % 8 == 0);
        CHECK(field.offset + size <= bytes.size());
        fields[name] = field;
    }
    return fields;
}

RglFile preset_file(const char* name, RglColours colours, double error) {
    const Design design = load_design(std::string(NACRE_SOURCE_DIR "/presets/") + name + ".nacre");
    return rgl_file(design, bake(design), colours, error, {}, {});
}

}  // namespace

TEST_CASE("measured material: where uniform points go, and back") {
    Random random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 20; ++i) {
        const SquareDensity density = random_density({2 + i % 7, 2 + i % 5}, random);
        const MixedDensity::Part part[] = {{&density, 1}};
        for (int j = 0; j < 100; ++j) {
            const dvec2 u{uniform(random), uniform(random)};
            const dvec2 back = MixedDensity(part).uniform(density.place(u));
            CHECK(back.x == doctest::Approx(u.x).epsilon(1e-9));
            CHECK(back.y == doctest::Approx(u.y).epsilon(1e-9));
        }
    }
}

TEST_CASE("measured material: points lie as densely as the density says") {
    Random random(4);
    const SquareDensity density = random_density({5, 4}, random);
    // The mean of x, of which each cell's part is known in closed form.
    double expected = 0, mean = 0;
    const glm::ivec2 size = density.size();
    const auto value = [&](int x, int y) {
        return density.values()[static_cast<std::size_t>(y * size.x + x)];
    };
    for (int y = 0; y + 1 < size.y; ++y)
        for (int x = 0; x + 1 < size.x; ++x) {
            const double width = 1.0 / (size.x - 1), low = 0.5 * (value(x, y) + value(x, y + 1));
            const double high = 0.5 * (value(x + 1, y) + value(x + 1, y + 1));
            expected += width / (size.y - 1) * (x * width * (low + high) / 2 + width * (low / 6 + high / 3));
        }
    constexpr int side = 400;
    for (int i = 0; i < side * side; ++i)
        mean +=
            density.place({(i % side + 0.5) / side, (static_cast<double>(i) / side + 0.5 / side) / side}).x /
            (side * side);
    CHECK(mean == doctest::Approx(expected).epsilon(1e-4));
}

TEST_CASE("measured material: each primary's spectrum has its colour under D65") {
    glm::dmat3 colours(0);
    for (const SpectralNode& node : spectral_nodes(1)) {
        std::size_t i = 0;
        while (i + 2 < primary_wavelengths.size() &&
               static_cast<double>(primary_wavelengths[i + 1]) < node.wavelength)
            ++i;
        const double low = primary_wavelengths[i], high = primary_wavelengths[i + 1];
        const double part = (node.wavelength - low) / (high - low);
        const dvec3 spectrum = primary_spectra[i] * (1 - part) + primary_spectra[i + 1] * part;
        for (int c = 0; c < 3; ++c) colours[c] += node.weight * spectrum[c];
    }
    for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) CHECK(std::abs(colours[c][d] - (c == d ? 1 : 0)) < 1e-6);
    for (const dvec3& spectrum : primary_spectra) {
        CHECK(spectrum.x + spectrum.y + spectrum.z == doctest::Approx(1).epsilon(1e-9));
        CHECK(glm::all(glm::greaterThanEqual(spectrum, dvec3(0))));
    }
}

TEST_CASE("measured material: the file holds what its readers want") {
    const RglFile rgb = preset_file("ggx-steel", RglColours::rgb, 0.05);
    const auto fields = fields_of(rgb.bytes);
    for (const char* name : {"phi_i", "theta_i", "ndf", "sigma", "vndf", "luminance", "rgb"}) {
        CAPTURE(name);
        CHECK(fields.at(name).type == 10);
    }
    CHECK(fields.at("description").type == 1);
    CHECK(fields.at("jacobian").shape == std::vector<std::size_t>{1});
    CHECK(rgb.bytes[fields.at("jacobian").offset] == 1);
    const auto& shape = fields.at("rgb").shape;
    REQUIRE(shape.size() == 5);
    CHECK(shape[0] == fields.at("phi_i").shape[0]);
    CHECK(shape[1] == fields.at("theta_i").shape[0]);
    CHECK(shape[2] == 3);
    CHECK(shape[3] == shape[4]);
    CHECK(fields.at("luminance").shape == std::vector{shape[0], shape[1], shape[3], shape[4]});
    for (std::size_t i = 0; i < shape[3] * shape[4]; ++i) {
        float value;
        std::memcpy(&value, rgb.bytes.data() + fields.at("luminance").offset + 4 * i, 4);
        REQUIRE(value > 0);
    }
    if (cheap) return;
    const auto spectral = fields_of(preset_file("ggx-steel", RglColours::spectral, 0.05).bytes);
    CHECK(spectral.at("spectra").shape[2] == spectral.at("wavelengths").shape[0]);
    CHECK(spectral.count("rgb") == 0);
}

TEST_CASE("measured material: the error follows what is asked, within the format's sizes" *
          doctest::skip(cheap)) {
    const RglFile coarse = preset_file("ggx-steel", RglColours::rgb, 0.02);
    const RglFile fine = preset_file("ggx-steel", RglColours::rgb, 0.005);
    CHECK(coarse.error.misplaced <= 0.02);
    CHECK(fine.error.misplaced <= 0.005);
    CHECK(fine.error.median < 0.003);
    CHECK(fine.error.ninety_fifth < 0.04);
    CHECK(coarse.bytes.size() < fine.bytes.size());
    CHECK(fine.bytes.size() <= 1'000'000);
    const RglFile turned = preset_file("brushed-gold", RglColours::rgb, 0.001);
    CHECK(turned.error.misplaced < 0.015);
    CHECK(turned.error.median < 0.003);
    CHECK(turned.error.ninety_fifth < 0.06);
    CHECK(turned.bytes.size() <= 24'000'000);
}

TEST_CASE(
    "measured material: what a reader evaluates is the design, of other pairs than the claim was measured "
    "on") {
    for (const char* name : {"matt-ceramic", "scarlet-car-paint"}) {
        if (cheap && name == std::string("scarlet-car-paint")) continue;
        CAPTURE(name);
        const Design design = load_design(std::string(NACRE_SOURCE_DIR "/presets/") + name + ".nacre");
        const auto tables = bake(design);
        const RglTables rgl = rgl_tables(*tables, {1, 20, {1024, 2}, {256, 2}, {28, 28}, {52, 52}}, {});
        const RglError claimed = rgl_file(design, tables, RglColours::rgb, 1e-4, {}, {}).error;
        const Brdf brdf(tables);
        Random random(99);
        double away = 0, all = 0;
        for (int i = 0; i < 4000; ++i) {
            const double z = std::sqrt(1 - (i + 0.5) / 4000), phi = 2.4 * i;
            const dvec3 k1{std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z};
            const auto drawn = brdf.sample(k1, random);
            if (!drawn) continue;
            const double exact = luminance(drawn->weight);
            away += std::abs(luminance(rgl.evaluate(k1, drawn->k2)) / drawn->pdf - exact);
            all += exact;
        }
        CHECK(away / all < 1.5 * claimed.misplaced + 0.002);
    }
}
