// Toward what lay where the brush came from. Copies are averaged where they meet.
#include <cmath>
#include <vector>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

// What lay where the brush came from.
class Smear {
  public:
    Smear(const Raster& raster, const Dab& dab)
        : before_(extended_past_rim(raster).values),
          side_(raster.width),
          ring_(dab.symmetry.kind == SymmetryKind::ring) {
        dvec3 from = dab.from;
        if (ring_) {  // only the way from or to the pole counts
            const double sine = std::hypot(dab.at.x, dab.at.y), r = std::hypot(from.x, from.y);
            from = sine > 0 ? dvec3(dab.at.x / sine * r, dab.at.y / sine * r, from.z) : dvec3(r, 0, from.z);
        }
        back_ = glm::transpose(shortest_rotation(from, dab.at));
        images_ = symmetry_images(dab.symmetry);
    }

    double operator()(const SeenTexel& texel) const {
        dvec3 source = back_ * texel.original;
        if (ring_) {
            const double r = std::hypot(texel.h.x, texel.h.y), s = std::hypot(source.x, source.y);
            source = r > 0 ? dvec3(texel.h.x / r * s, texel.h.y / r * s, source.z) : dvec3(s, 0, source.z);
        } else {
            source = images_[texel.image] * source;
        }
        return raster_value(before_, side_, disk_point(source));
    }

  private:
    std::vector<float> before_;
    int side_;
    bool ring_;
    glm::dmat3 back_;
    std::vector<glm::dmat3> images_;
};

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    const Smear source(raster, dab);
    visit_covered(raster, dab, [&](const SeenTexel& texel, double amount) {
        scratch.add(texel.index, amount, source(texel));
    });
    scratch.pull(raster.values, [&](std::size_t index) { return scratch.target(index); });
}

void icon(const IconPen& pen) {
    pen.line(
        {{0.14f, 0.66f}, {0.27f, 0.46f}, {0.40f, 0.46f}, {0.52f, 0.62f}, {0.64f, 0.62f}, {0.82f, 0.32f}});
    pen.line({{0.64f, 0.30f}, {0.84f, 0.28f}, {0.86f, 0.48f}});
}

}  // namespace

const PaintToolInfo smear_tool{.face = {.name = "Smear",
                                        .key = 'M',
                                        .about = "Pushes paint along.",
                                        .more = "The highlight is drawn out like wet paint.",
                                        .icon = icon},
                               .work = DabTool{.dab = dab, .at_press = false}};

}  // namespace nacre
