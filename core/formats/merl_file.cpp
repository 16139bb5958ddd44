#include "core/formats/merl_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/bake/brdf.h"
#include "core/bake/workers.h"

namespace nacre {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr double degree = std::numbers::pi / 180;

}  // namespace

MerlPair merl_pair(double theta_h, double theta_d, double phi_d) {
    const double h = (theta_h / merl_theta_h) * (theta_h / merl_theta_h) * 90 * degree;
    const double d = theta_d * degree, phi = phi_d * degree;
    // The light as h sees it, then turned with h from n toward the tangent (Rusinkiewicz 1998).
    const glm::dvec3 seen{std::sin(d) * std::cos(phi), std::sin(d) * std::sin(phi), std::cos(d)};
    const glm::dvec3 k1{std::cos(h) * seen.x + std::sin(h) * seen.z, seen.y,
                        std::cos(h) * seen.z - std::sin(h) * seen.x};
    return {k1, mirrored(k1, {std::sin(h), 0, std::cos(h)})};
}

ExportWriter merl_writer(const Design& design, const ExportSettings& settings, double part,
                         const std::stop_token& stop, const std::function<void(double)>& progress) {
    const Brdf brdf(bake(design, settings.bake, stop, [&](double done) {
        if (progress) progress(0.5 * done);
    }));
    const std::size_t plane = std::size_t{merl_theta_h} * merl_theta_d * merl_phi_d;
    std::vector<double> values(3 * plane);
    Workers(settings.bake.threads, stop).for_each(merl_theta_h, [&](int h) {
        for (int d = 0; d < merl_theta_d; ++d)
            for (int phi = 0; phi < merl_phi_d; ++phi) {
                const MerlPair pair = merl_pair(h + part, d + part, phi + part);
                const bool above = pair.k1.z > 0 && pair.k2.z > 0;
                const dvec3 stored = above ? brdf.evaluate(pair.k1, pair.k2) * merl_scale : dvec3(-1);
                const std::size_t at = static_cast<std::size_t>((h * merl_theta_d + d) * merl_phi_d + phi);
                for (std::size_t c = 0; c < 3; ++c)
                    values[c * plane + at] = stored[static_cast<glm::length_t>(c)];
            }
    });
    const std::int32_t sizes[] = {merl_theta_h, merl_theta_d, merl_phi_d};
    std::string bytes(reinterpret_cast<const char*>(sizes), sizeof sizes);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    if (progress) progress(1);
    return ExportWriter(std::move(bytes));
}

}  // namespace nacre
