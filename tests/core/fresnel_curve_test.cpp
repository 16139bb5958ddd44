// Fresnel models that are tables: measured materials, thin films and drawn curves.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <complex>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <vector>

#include "core/model/quadrature.h"
#include "core/model/shading.h"
#include "core/model/spectral/fresnel_curve.h"
#include "core/model/spectral/spectral_colour.h"
#include "core/model/spectral/thin_film.h"
#include "core/shading/surface.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using Complex = std::complex<double>;
using Shader = Shading<double>;
using std::numbers::pi;

#include "core/model/spectral/cie_tables.inc"

double between(const auto& values, double place, auto part) {
    const auto i = std::min(static_cast<std::size_t>(place), values.size() - 2);
    const double t = place - static_cast<double>(i);
    return part(values[i]) * (1 - t) + part(values[i + 1]) * t;
}

// The colour of a spectrum by Gauss-Legendre's rule on pieces of 5 nm and the matrix that IEC 61966-2-1
// prints, white scaled to (1, 1, 1): nothing here is the product's but the tables of the CIE.
dvec3 integrated(const auto& reflectance) {
    const glm::dmat3 to_rgb = glm::transpose(
        glm::dmat3({3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}));
    dvec3 sum{0}, white{0};
    for (double begin = 380; begin < 780; begin += 5)
        for (const QuadraturePoint& point : gauss_legendre<7>()) {
            const double wavelength = begin + 5 * point.x;
            const double light = between(daylight, (wavelength - 380) / 5, [](double v) { return v; });
            dvec3 xyz;
            for (int i = 0; i < 3; ++i)
                xyz[i] =
                    light * point.weight * between(observer, wavelength - 380, [i](dvec3 v) { return v[i]; });
            white += xyz;
            sum += xyz * reflectance(wavelength);
        }
    return (to_rgb * sum) / (to_rgb * white);
}

// Fresnel's equations in complex numbers.
double conductor(Complex index, double cosine) {
    const Complex inside = std::sqrt(index * index - (1 - cosine * cosine));
    const Complex s = (cosine - inside) / (cosine + inside);
    const Complex p = (index * index * cosine - inside) / (index * index * cosine + inside);
    return (std::norm(s) + std::norm(p)) / 2;
}

Complex measured_index(Material material, double wavelength) {
    const auto indices = material_data(material).indices;
    std::size_t i = 0;
    while (i + 2 < indices.size() && indices[i + 1].wavelength < wavelength) ++i;
    const auto &a = indices[i], &b = indices[i + 1];
    const double t = (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
    return Complex{a.n, a.k} * (1 - t) + Complex{b.n, b.k} * t;
}

// A stack by the characteristic matrix of each film (Born & Wolf, sec. 1.6.2), one polarisation.
double by_matrices(const std::vector<OpticalFilm>& films, Complex substrate, double wavelength, double cosine,
                   bool p) {
    const double s2 = 1 - cosine * cosine;
    const auto admittance = [&](Complex n) {
        const Complex c = std::sqrt(1.0 - s2 / (n * n));
        return p ? n / c : n * c;
    };
    Complex b = 1, c = admittance(substrate);
    for (auto film = films.rbegin(); film != films.rend(); ++film) {
        const Complex n = film->ior, inside = std::sqrt(1.0 - s2 / (n * n)), y = admittance(n);
        const Complex phase = 2 * pi * n * inside * film->thickness / wavelength;
        const Complex i{0, -1};
        const Complex b2 = std::cos(phase) * b + i * std::sin(phase) / y * c;
        c = i * y * std::sin(phase) * b + std::cos(phase) * c;
        b = b2;
    }
    const Complex y0 = p ? 1 / cosine : cosine;
    return std::norm((y0 * b - c) / (y0 * b + c));
}

std::vector<OpticalFilm> random_films(Random& random, int count) {
    std::vector<OpticalFilm> films;
    for (int i = 0; i < count; ++i)
        films.push_back({1 + 2 * uniform_random(random), 900 * uniform_random(random)});
    return films;
}

dvec3 clipped(dvec3 colour) { return clip_to_gamut(colour).colour; }

// The largest difference between what the shader reads and the integral, at cosines that are no nodes.
double table_error(const Fresnel& fresnel, const Reflectance& exact) {
    const Reflectance f = reflectance_of(fresnel);
    double error = 0;
    for (int i = 0; i < 300; ++i) {
        const double cosine = std::pow((i + 0.37) / 300, 2);
        const dvec3 off = glm::abs(f(cosine) - clipped(exact(cosine)));
        error = std::max({error, off.x, off.y, off.z});
    }
    return error;
}

}  // namespace

TEST_SUITE_BEGIN("fresnel curve");

TEST_CASE("what reflects all light is white, by every rule") {
    for (const int steps : {1, 2, 5}) {
        dvec3 sum{0};
        for (const SpectralNode& node : spectral_nodes(steps)) sum += node.weight;
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(1).epsilon(1e-12));
    }
    CHECK(clip_to_gamut({-0.25, 0.5, 1.125}).colour == dvec3{0, 0.5, 1});
    CHECK(clip_to_gamut({-0.25, 0.5, 1.125}).clipped == 0.25);
}

TEST_CASE("every material has indices from end to end, and positive ones") {
    CHECK(material_names.size() >= 20);
    for (std::size_t i = 0; i < material_names.size(); ++i) {
        CAPTURE(material_names[i]);
        const MaterialData& data = material_data(static_cast<Material>(i));
        CHECK(std::string_view(data.source).size() > 20);
        CHECK(data.indices.front().wavelength <= spectrum_begin);
        CHECK(data.indices.back().wavelength >= spectrum_end);
        for (std::size_t j = 0; j < data.indices.size(); ++j) {
            CHECK(data.indices[j].n > 0);
            CHECK(data.indices[j].k >= 0);
            if (j > 0) CHECK(data.indices[j].wavelength > data.indices[j - 1].wavelength);
        }
    }
}

TEST_CASE("every material is what another quadrature makes of its n and k") {
    for (std::size_t i = 0; i < material_names.size(); ++i) {
        const auto material = static_cast<Material>(i);
        CAPTURE(material_names[i]);
        const Reflectance f = reflectance_of(MeasuredFresnel{material});
        for (const double cosine : {1.0, 0.8, 0.5, 0.3, 1.0 / 7, 0.05}) {
            const dvec3 other = clipped(integrated(
                [&](double wavelength) { return conductor(measured_index(material, wavelength), cosine); }));
            for (int c = 0; c < 3; ++c) CHECK(std::fabs(f(cosine)[c] - other[c]) < 2e-3);
        }
        CHECK(table_error(MeasuredFresnel{material}, MeasuredFresnel{material}.reflectance()) < 2e-3);
    }
}

TEST_CASE("tables of films are within 5e-3 of the integral, and have more nodes where they need them") {
    const std::vector<FilmFresnel> films = {
        FilmFresnel{},
        {DielectricFresnel{1}, {{1.33, 300}}},
        {DielectricFresnel{1}, {{1.33, 2000}}},
        {DielectricFresnel{1.5}, {{2.4, 1500}}},
        {ConductorFresnel{}, {{1.46, 700}}},
        {MeasuredFresnel{Material::gold}, {{2.4, 2000}}},
        {MeasuredFresnel{Material::aluminium}, {{1.38, 100}, {2.4, 60}, {1.38, 1500}, {2.4, 1000}}}};
    int most = 0;
    for (const FilmFresnel& film : films) {
        CHECK(table_error(film, film.reflectance()) < 5e-3);
        most = std::max(most, film.shader().curve->nodes);
    }
    CHECK(FilmFresnel{}.shader().curve->nodes == curve_intervals_min + 1);
    CHECK(most > curve_intervals_min + 1);
}

TEST_CASE("the integral over wavelengths does not depend on its steps") {
    const std::vector<OpticalFilm> films = {{2.4, 2000}, {1.3, 2000}};
    const auto colour = [&](int steps) {
        dvec3 sum{0};
        for (const SpectralNode& node : spectral_nodes(steps))
            sum += node.weight *
                   film_reflectance(films, index_at(Material::gold, node.wavelength), node.wavelength, 0.7);
        return sum;
    };
    FilmFresnel film{MeasuredFresnel{Material::gold}, {{2.4, 2000}, {1.3, 2000}}};
    for (int c = 0; c < 3; ++c) CHECK(std::fabs(film.reflectance()(0.7)[c] - colour(20)[c]) < 2e-3);
}

TEST_CASE("a film of no thickness, and none at all, is plain Fresnel") {
    for (const double cosine : {1.0, 0.6, 0.2, 0.01}) {
        for (const std::vector<FilmLayer>& stack :
             {std::vector<FilmLayer>{}, {{2.1, 0}}, {{1.4, 0}, {3, 0}}}) {
            const FilmFresnel glass{DielectricFresnel{1.6}, stack}, metal{ConductorFresnel{}, stack};
            const ConductorFresnel own;
            for (int c = 0; c < 3; ++c) {
                CHECK(std::fabs(glass.reflectance()(cosine)[c] -
                                Shader::dielectric_reflectance(1.6, cosine)) < 1e-12);
                CHECK(std::fabs(metal.reflectance()(cosine)[c] -
                                Shader::conductor_reflectance(own.eta[c], own.k[c], cosine)) < 1e-12);
            }
            const dvec3 coated = FilmFresnel{MeasuredFresnel{}, stack}.reflectance()(cosine);
            const dvec3 bare = MeasuredFresnel{}.reflectance()(cosine);
            for (int c = 0; c < 3; ++c) CHECK(std::fabs(coated[c] - bare[c]) < 1e-12);
        }
    }
}

TEST_CASE("a film of the index of what it lies on has no fringes") {
    for (const double thickness : {1.0, 333.0, 1999.0})
        for (const double cosine : {1.0, 0.5, 0.03}) {
            const OpticalFilm film{1.7, thickness};
            CHECK(film_reflectance({&film, 1}, 1.7, 500, cosine) ==
                  doctest::Approx(Shader::dielectric_reflectance(1.7, cosine)).epsilon(1e-12));
        }
}

TEST_CASE("a stack that loses nothing before a perfect mirror reflects everything") {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const std::vector<OpticalFilm> films = random_films(random, 1 + i % 5);
        const double cosine = uniform_random(random), wavelength = 380 + 400 * uniform_random(random);
        CHECK(film_reflectance(films, {0, 1 + 4 * uniform_random(random)}, wavelength, cosine) ==
              doctest::Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("a quarter of a wave of the root of the index reflects nothing") {
    const double n = 2.25, wavelength = 550;
    const OpticalFilm film{std::sqrt(n), wavelength / (4 * std::sqrt(n))};
    CHECK(film_reflectance({&film, 1}, n, wavelength, 1) < 1e-15);
    CHECK(film_reflectance({&film, 1}, n, wavelength / 2, 1) ==
          doctest::Approx(Shader::dielectric_reflectance(n, 1)).epsilon(1e-9));
}

TEST_CASE("stacks agree with characteristic matrices, and never reflect more than all light") {
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        const std::vector<OpticalFilm> films = random_films(random, i % 6);
        const Complex substrate{0.05 + 3 * uniform_random(random),
                                i % 3 == 0 ? 0 : 6 * uniform_random(random)};
        const double cosine = i % 7 == 0 ? 1e-3 : uniform_random(random),
                     wavelength = 380 + 400 * uniform_random(random);
        const double r = film_reflectance(films, substrate, wavelength, cosine);
        const double matrices = (by_matrices(films, substrate, wavelength, cosine, false) +
                                 by_matrices(films, substrate, wavelength, cosine, true)) /
                                2;
        CHECK(r == doctest::Approx(matrices).epsilon(1e-8));
        CHECK(r >= 0);
        CHECK(r <= 1 + 1e-12);
    }
    const OpticalFilm air{1, 500};
    for (const double cosine : {1.0, 0.5, 0.0}) CHECK(film_reflectance({&air, 1}, 1, 500, cosine) == 0);
}

TEST_CASE("a drawn curve passes its points, and is straight over the cosine between them") {
    const CurveFresnel curve{{{20, {0.1, 0.2, 0.9}}, {60, {0.5, 0.2, 0.3}}, {90, dvec3{1}}}};
    const Reflectance f = curve.reflectance();
    CHECK(f(1) == dvec3{0.1, 0.2, 0.9});
    CHECK(f(std::cos(pi / 3)).x == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(f(0) == dvec3{1});
    CHECK(f(0.25).z == doctest::Approx(0.65).epsilon(1e-12));
    CHECK(table_error(curve, f) < 2e-3);
    CHECK(CurveFresnel{{{45, dvec3{1}}, {45.01, dvec3{0}}}}.shader().curve->error > 0.1);
}

TEST_SUITE_END();
