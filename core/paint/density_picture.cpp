#include "core/paint/density_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/model/disk.h"
#include "core/paint/colour_map.h"
#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

constexpr double decades = 4;
constexpr int peak_side = 160;  // samples a side
constexpr int colours = 1024;

// L*/100 of a luminance, and its inverse (CIE 15:2004, eq. 8.3), both of white.
constexpr double knee = 6.0 / 29;
constexpr double slope = 1 / (3 * knee * knee);

double lightness(double y) {
    return 1.16 * (y > knee * knee * knee ? std::cbrt(y) : slope * y + 4.0 / 29) - 0.16;
}

double luminance_of(double l) {
    const double t = (l + 0.16) / 1.16;
    return t > knee ? t * t * t : (t - 4.0 / 29) / slope;
}

bool is_perceptual(ScaleKind kind) { return kind == ScaleKind::perceptual || kind == ScaleKind::material; }

std::array<glm::u8vec3, colours> colour_table() {
    std::array<glm::u8vec3, colours> table{};
    for (int i = 0; i < colours; ++i) table[static_cast<std::size_t>(i)] = inferno(i / (colours - 1.0));
    return table;
}

// Places to look up p at, side by side.
class Directions {
  public:
    void add(dvec3 h) {
        x_.push_back(h.x);
        y_.push_back(h.y);
        z_.push_back(h.z);
    }

    std::vector<double> densities(const FacetDistribution* p) const {
        std::vector<double> values(x_.size());
        if (p != nullptr) p->densities({x_.data(), y_.data(), z_.data(), x_.size()}, values.data());
        return values;
    }

  private:
    std::vector<double> x_, y_, z_;
};

// All over the whole sphere's disk, so that facets below the horizon count too.
Directions peak_grid() {
    Directions grid;
    for (int row = 0; row < peak_side; ++row)
        for (int column = 0; column < peak_side; ++column) {
            const glm::dvec2 at = std::numbers::sqrt2 * glm::dvec2(2 * (column + 0.5) / peak_side - 1,
                                                                   1 - 2 * (row + 0.5) / peak_side);
            if (glm::dot(at, at) < 2) grid.add(disk_direction(at));
        }
    return grid;
}

}  // namespace

double DensityScale::position(double p) const {
    if (!(p > 0) || !(peak > 0)) return 0;
    const double part = p / peak;
    if (is_perceptual(kind)) return std::min(lightness(part), 1.0);
    return std::clamp(kind == ScaleKind::logarithmic ? 1 + std::log10(part) / decades : part, 0.0, 1.0);
}

double DensityScale::value(double position) const {
    if (is_perceptual(kind)) return peak * luminance_of(position);
    return peak * (kind == ScaleKind::logarithmic ? std::pow(10, (position - 1) * decades) : position);
}

double peak_density(const FacetDistribution& p) {
    static const Directions grid = peak_grid();
    Directions axes;
    for (const PlacedLobe& placed : p.lobes()) axes.add(placed.frame[2]);
    double peak = 0;
    for (const Directions* places : {&grid, static_cast<const Directions*>(&axes)})
        for (const double density : places->densities(&p)) peak = std::max(peak, density);
    return peak;
}

HemispherePicture hemisphere_picture(const HemisphereView& view, int divisor, const RowColours& colours_of) {
    HemispherePicture picture;
    picture.size = glm::max(glm::ivec2(glm::ceil(view.size() / static_cast<double>(divisor))), 1);
    picture.rgba.reserve(static_cast<std::size_t>(picture.size.x * picture.size.y) * 4);
    std::vector<double> covered(static_cast<std::size_t>(picture.size.x));
    std::vector<dvec3> directions;
    for (int row = 0; row < picture.size.y; ++row) {
        directions.clear();
        for (int column = 0; column < picture.size.x; ++column) {
            const glm::dvec2 pixel = glm::dvec2(column + 0.5, row + 0.5) * static_cast<double>(divisor);
            double& share = covered[static_cast<std::size_t>(column)];
            share = view.coverage(pixel);
            if (share > 0) directions.push_back(view.nearest_direction(pixel));
        }
        const std::vector<glm::u8vec3> row_colours = colours_of(directions);
        auto colour = row_colours.begin();
        for (const double share : covered) {
            const glm::u8vec3 c = share > 0 ? *colour++ : glm::u8vec3(0);
            const auto alpha = static_cast<std::uint8_t>(std::lround(255 * share));
            picture.rgba.insert(picture.rgba.end(), {c.x, c.y, c.z, alpha});
        }
    }
    return picture;
}

HemispherePicture density_picture(const FacetDistribution* p, const HemisphereView& view,
                                  const DensityScale& scale, int divisor) {
    static const std::array<glm::u8vec3, colours> table = colour_table();
    return hemisphere_picture(view, divisor, [&](std::span<const dvec3> row) {
        Directions directions;
        for (const dvec3 h : row) directions.add(h);
        std::vector<glm::u8vec3> shown;
        shown.reserve(row.size());
        for (const double density : directions.densities(p))
            shown.push_back(
                table[static_cast<std::size_t>(std::lround(scale.position(density) * (colours - 1)))]);
        return shown;
    });
}

void veil_what_is_hidden(HemispherePicture& picture, const HemisphereView& view, int divisor,
                         const Raster& mask, const glm::dmat3& layer_frame) {
    constexpr glm::dvec3 veil(28, 120, 130);  // no colour of p is like it
    constexpr double thickness = 0.75;        // where all is hidden
    const glm::dmat3 to_layer = glm::transpose(layer_frame);
    std::size_t index = 0;
    for (int row = 0; row < picture.size.y; ++row)
        for (int column = 0; column < picture.size.x; ++column, index += 4) {
            if (picture.rgba[index + 3] == 0) continue;
            const glm::dvec2 pixel = glm::dvec2(column + 0.5, row + 0.5) * static_cast<double>(divisor);
            const dvec3 h = to_layer * view.nearest_direction(pixel);
            const double open = h.z >= 0 ? raster_value(mask.values, mask.width, disk_point(h)) : 0;
            const double hidden = thickness * std::clamp(1 - open, 0.0, 1.0);
            for (int c = 0; c < 3; ++c) {
                auto& channel = picture.rgba[index + static_cast<std::size_t>(c)];
                channel = static_cast<std::uint8_t>(
                    std::lround(std::lerp(static_cast<double>(channel), veil[c], hidden)));
            }
        }
}

}  // namespace nacre
