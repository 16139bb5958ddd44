#include "core/bake/symmetry.h"

#include <algorithm>
#include <cmath>

#include "core/model/disk_texels.h"

namespace nacre {
namespace {

bool same_angle(double a, double b, double period) { return std::fabs(std::remainder(a - b, period)) < 1e-9; }

bool picture_mirrors(const Raster& r, bool across_y) {
    for (int row = 0; row < r.height; ++row)
        for (int column = 0; column < r.width; ++column) {
            const int other =
                across_y ? row * r.width + (r.width - 1 - column) : (r.height - 1 - row) * r.width + column;
            if (!on_disk(r.width, row, column)) continue;
            if (r.values[static_cast<std::size_t>(row * r.width + column)] !=
                r.values[static_cast<std::size_t>(other)])
                return false;
        }
    return true;
}

// Both axes of the lobe's own frame are mirrors of the pictures it holds; no other plane is looked for.
struct PictureMirrors {
    bool x = true;  // the plane through the lobe's x axis
    bool y = true;
};

PictureMirrors picture_mirrors(const Layer& layer) {
    PictureMirrors mirrors;
    auto add = [&](const Picture& picture) {
        mirrors.x = mirrors.x && picture_mirrors(*picture.raster, false);
        mirrors.y = mirrors.y && picture_mirrors(*picture.raster, true);
    };
    visit_pictures(layer.lobe, [&](const Picture& picture, std::string_view) { add(picture); });
    if (layer.modulation) add(layer.modulation->image);
    return mirrors;
}

bool is_round(const Layer& layer) { return period_of(layer.lobe) == 0 && !holds_picture(layer); }

// A layer that holds facets, and the mirrors of its pictures, which are looked for once.
struct Part {
    const Layer* layer = nullptr;
    PictureMirrors mirrors;
};

bool upright(const Layer& layer) { return std::fabs(layer.tilt) < 1e-12; }

// `b` is the mirror image of `a` about the azimuth `axis`.
bool mirrored(const Part& part, const Layer& b, double axis) {
    const Layer& a = *part.layer;
    if (a.weight != b.weight || a.lobe != b.lobe || a.modulation != b.modulation || a.tilt != b.tilt ||
        a.tint != b.tint)
        return false;
    if (!upright(a) && !same_angle(2 * axis - a.azimuth, b.azimuth, 360)) return false;
    if (is_round(a)) return true;
    const double wanted = 2 * axis - a.rotation;
    if (!holds_picture(a)) return same_angle(wanted, b.rotation, period_of(a.lobe));
    return (part.mirrors.x && same_angle(wanted, b.rotation, 360)) ||
           (part.mirrors.y && same_angle(wanted + 180, b.rotation, 360));
}

bool has_mirror(const std::vector<Part>& parts, double axis) {
    std::vector<bool> taken(parts.size(), false);
    for (const Part& part : parts) {
        bool found = false;
        for (std::size_t j = 0; j < parts.size() && !found; ++j) {
            if (taken[j] || !mirrored(part, *parts[j].layer, axis)) continue;
            taken[j] = found = true;
        }
        if (!found) return false;
    }
    return true;
}

std::vector<double> candidate_axes(const std::vector<Part>& parts) {
    std::vector<double> axes = {0};
    for (const Part& a : parts) {
        for (const double angle : {a.layer->azimuth, a.layer->rotation}) {
            axes.push_back(angle);
            for (const Part& b : parts) {
                axes.push_back(0.5 * (angle + b.layer->azimuth));
                axes.push_back(0.5 * (angle + b.layer->rotation));
            }
        }
    }
    for (std::size_t i = 0, n = axes.size(); i < n; ++i) axes.push_back(axes[i] + 90);
    return axes;
}

}  // namespace

DistributionSymmetry find_symmetry(const Distribution& distribution) {
    std::vector<Part> parts;
    bool isotropic = true;
    for (const Layer& layer : distribution.layers) {
        if (!counts(layer)) continue;
        parts.push_back({&layer, picture_mirrors(layer)});
        isotropic = isotropic && is_round(layer) && upright(layer);
    }
    if (isotropic) return {Symmetry::isotropic, 0};
    DistributionSymmetry best;
    for (const double axis : candidate_axes(parts)) {
        if (!has_mirror(parts, axis)) continue;
        if (has_mirror(parts, axis + 90)) return {Symmetry::quarter, axis};
        if (best.symmetry == Symmetry::none) best = {Symmetry::half, axis};
    }
    return best;
}

const char* name_of(Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return "isotropic";
        case Symmetry::quarter:
            return "quarter";
        case Symmetry::half:
            return "half";
        case Symmetry::none:
            return "none";
    }
    return "";
}

}  // namespace nacre
