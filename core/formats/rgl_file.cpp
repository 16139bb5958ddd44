#include "core/formats/rgl_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "core/bake/brdf.h"
#include "core/formats/rgl_tables.h"
#include "core/formats/tensor_file.h"
#include "core/image/luminance.h"
#include "core/model/spectral/primary_spectra.h"

namespace nacre {
namespace {

constexpr int pairs = 2000;
constexpr std::uint64_t seed = 20180801;

// Readers want `values` to be as wide as high.
std::span<const RglSize> sizes(bool isotropic, RglColours colours) {
    static constexpr std::array round_rgb = {RglSize{1, 10, {128, 2}, {128, 2}, {24, 24}, {24, 24}},
                                             RglSize{1, 14, {256, 2}, {256, 2}, {24, 24}, {36, 36}},
                                             RglSize{1, 20, {1024, 2}, {256, 2}, {28, 28}, {52, 52}}};
    static constexpr std::array round_spectral = {round_rgb[0], round_rgb[1],
                                                  RglSize{1, 18, {1024, 2}, {256, 2}, {28, 28}, {42, 42}}};
    static constexpr std::array turned_rgb = {RglSize{17, 12, {256, 128}, {128, 64}, {24, 24}, {28, 28}},
                                              RglSize{25, 14, {512, 256}, {256, 128}, {24, 28}, {39, 39}},
                                              RglSize{33, 16, {1024, 512}, {256, 128}, {16, 48}, {48, 48}}};
    static constexpr std::array turned_spectral = {
        turned_rgb[0], turned_rgb[1], RglSize{33, 16, {1024, 512}, {256, 128}, {16, 48}, {36, 36}}};
    if (colours == RglColours::rgb) return isotropic ? std::span(round_rgb) : std::span(turned_rgb);
    return isotropic ? std::span(round_spectral) : std::span(turned_spectral);
}

// A direction of light that falls evenly on the surface from everywhere.
dvec3 incident(Random& random) {
    const double sine = std::sqrt(uniform_random(random));
    const double phi = 2 * std::numbers::pi * uniform_random(random);
    return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - sine * sine)};
}

RglError error_of(const RglTables& rgl, const Brdf& brdf) {
    Random random(seed);
    double away = 0, all = 0;
    std::vector<double> relative;
    for (int i = 0; i < pairs; ++i) {
        const dvec3 k1 = incident(random);
        if (const auto drawn = brdf.sample(k1, random)) {
            const double exact = luminance(drawn->weight);
            away += std::abs(luminance(rgl.evaluate(k1, drawn->k2)) / drawn->pdf - exact);
            all += exact;
        }
        const dvec3 k2 = mirrored(k1, brdf.tables().distribution->sample_visible(k1, random));
        const double exact = k2.z > 0 ? luminance(brdf.evaluate(k1, k2)) * k2.z : 0;
        if (exact > 0) relative.push_back(std::abs(luminance(rgl.evaluate(k1, k2)) - exact) / exact);
    }
    std::sort(relative.begin(), relative.end());
    const auto at = [&](double part) {
        return relative.empty()
                   ? 0
                   : relative[static_cast<std::size_t>(part * static_cast<double>(relative.size() - 1))];
    };
    return {all > 0 ? away / all : 0, at(0.5), at(0.95)};
}

std::vector<float> floats(const std::vector<double>& values) { return {values.begin(), values.end()}; }

// The plane of each channel of each incident direction.
template <class Channel>
std::vector<float> planes(const RglTables& rgl, std::size_t channels, const Channel& channel) {
    const std::size_t size = rgl.values_of(1);
    std::vector<float> result;
    result.reserve(rgl.values.size() * channels);
    for (std::size_t incident = 0; incident < rgl.size.incident(); ++incident)
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < size; ++i)
                result.push_back(channel(rgl.values[rgl.values_of(incident) + i], c));
    return result;
}

void add_colours(const RglTables& rgl, RglColours colours, std::vector<Tensor>& tensors) {
    const std::size_t p = rgl.phi.size(), t = rgl.theta.size();
    const auto x = static_cast<std::size_t>(rgl.size.values.x),
               y = static_cast<std::size_t>(rgl.size.values.y);
    if (colours == RglColours::rgb) {
        tensors.push_back({"rgb", {p, t, 3, y, x}, planes(rgl, 3, [](glm::vec3 v, std::size_t c) {
                               return v[static_cast<glm::length_t>(c)];
                           })});
        return;
    }
    const std::size_t count = primary_wavelengths.size();
    tensors.push_back(
        {"wavelengths", {count}, std::vector<float>(primary_wavelengths.begin(), primary_wavelengths.end())});
    tensors.push_back({"spectra", {p, t, count, y, x}, planes(rgl, count, [](glm::vec3 v, std::size_t c) {
                           return static_cast<float>(glm::dot(dvec3(v), primary_spectra[c]));
                       })});
}

std::string bytes_of(const RglTables& rgl, const std::string& description, RglColours colours) {
    const std::size_t p = rgl.phi.size(), t = rgl.theta.size();
    const auto grid = [](glm::ivec2 size) {
        return std::vector{static_cast<std::size_t>(size.y), static_cast<std::size_t>(size.x)};
    };
    const auto of_each = [&](glm::ivec2 size) {
        return std::vector{p, t, static_cast<std::size_t>(size.y), static_cast<std::size_t>(size.x)};
    };
    std::vector<float> warps;
    for (const SquareDensity& warp : rgl.warp)
        warps.insert(warps.end(), warp.values().begin(), warp.values().end());
    std::vector<Tensor> tensors = {{"description",
                                    {description.size()},
                                    std::vector<std::uint8_t>(description.begin(), description.end())},
                                   {"phi_i", {p}, floats(rgl.phi)},
                                   {"theta_i", {t}, floats(rgl.theta)},
                                   {"ndf", grid(rgl.size.normals), rgl.ndf},
                                   {"sigma", grid(rgl.size.areas), rgl.sigma},
                                   {"vndf", of_each(rgl.size.warp), std::move(warps)},
                                   {"luminance", of_each(rgl.size.values), rgl.luminance},
                                   {"jacobian", {1}, std::vector<std::uint8_t>{1}}};
    add_colours(rgl, colours, tensors);
    return tensor_file(tensors);
}

std::string description_of(const Design& design, const RglError& error) {
    return fmt::format(
        "{}. Made by Nacre. Of the light {:.2g} goes another way than the design sends it; relative error of "
        "pairs that "
        "facets mirror: median {:.2g}, 95th percentile {:.2g}.{}{}",
        design.name, error.misplaced, error.median, error.ninety_fifth, design.note.empty() ? "" : "\n\n",
        design.note);
}

}  // namespace

RglFile rgl_file(const Design& design, const std::shared_ptr<const Tables>& tables, RglColours colours,
                 double error, const std::stop_token& stop, const std::function<void(double)>& progress) {
    const Brdf brdf(tables);
    const auto tried = sizes(tables->needs.symmetry.symmetry == Symmetry::isotropic, colours);
    for (std::size_t i = 0;; ++i) {
        if (progress) progress(static_cast<double>(i) / static_cast<double>(tried.size()));
        const RglTables rgl = rgl_tables(*tables, tried[i], stop);
        const RglError reached = error_of(rgl, brdf);
        if (reached.misplaced > error && i + 1 < tried.size()) continue;
        if (progress) progress(1);
        return {bytes_of(rgl, description_of(design, reached), colours), reached};
    }
}

ExportWriter rgl_writer(const Design& design, const ExportSettings& settings, RglColours colours,
                        const std::stop_token& stop, const std::function<void(double)>& progress) {
    const auto tables = bake(design, settings.bake, stop, {});
    RglFile file = rgl_file(design, tables, colours, settings.error, stop, progress);
    ExportWriter writer(std::move(file.bytes));
    writer.notes = {fmt::format(
        "Of the light {:.2g} % leaves another way than the design sends it{}.", 100 * file.error.misplaced,
        file.error.misplaced > settings.error ? ", more than was asked for: the format has no "
                                                "larger file for it"
                                              : "")};
    return writer;
}

}  // namespace nacre
