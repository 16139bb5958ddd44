#include "ui/layer_thumbnail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/disk.h"
#include "core/paint/colour_map.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr int rings = 6, sectors = 24;
constexpr int samples = 3;  // each way around a corner of the mesh, so that a narrow lobe is not missed

// A corner of the mesh on the disk, ring and sector as fractions.
glm::dvec2 corner_at(double ring, double sector) {
    const double r = std::min(std::max(ring, 0.0) / rings, 0.9999);
    const double angle = 2 * std::numbers::pi * sector / sectors;
    return {r * std::cos(angle), r * std::sin(angle)};
}

// The largest density near a corner.
double strongest(const PlacedLobe& placed, int ring, int sector) {
    double most = 0;
    for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j) {
            const double off_ring = (i - (samples - 1) / 2.0) / samples,
                         off_sector = (j - (samples - 1) / 2.0) / samples;
            const dvec3 h = disk_direction(corner_at(ring + off_ring, sector + off_sector));
            most = std::max(most, placed.lobe->density(glm::transpose(placed.frame) * h));
        }
    return most;
}

std::vector<ImU32> colours_of(const PlacedLobe& placed) {
    std::vector<double> values = {strongest(placed, 0, 0)};
    for (int ring = 1; ring <= rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) values.push_back(strongest(placed, ring, sector));
    const double peak = *std::max_element(values.begin(), values.end());
    std::vector<ImU32> colours;
    for (const double value : values) {
        const glm::u8vec3 c = inferno(peak > 0 ? std::sqrt(value / peak) : 0);
        colours.push_back(IM_COL32(c.x, c.y, c.z, 255));
    }
    return colours;
}

}  // namespace

void LayerThumbnails::update(const FacetDistribution* p, int revision) {
    if (revision == revision_) return;
    revision_ = revision;
    colours_.clear();
    if (!p) return;
    for (const PlacedLobe& placed : p->lobes()) {
        colours_.resize(std::max(colours_.size(), placed.layer + 1));
        colours_[placed.layer] = colours_of(placed);
    }
}

void LayerThumbnails::draw(std::size_t layer, ImVec2 corner, float side) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle(corner.x + side / 2, corner.y + side / 2);
    const float radius = side / 2 - 1;
    if (layer < colours_.size() && !colours_[layer].empty()) {
        const std::vector<ImU32>& colours = colours_[layer];
        const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
        list.PrimReserve(3 * sectors + 6 * sectors * (rings - 1), static_cast<int>(colours.size()));
        const auto base = static_cast<ImDrawIdx>(list._VtxCurrentIdx);
        list.PrimWriteVtx(middle, uv, colours[0]);
        for (int ring = 1; ring <= rings; ++ring)
            for (int sector = 0; sector < sectors; ++sector) {
                const glm::vec2 at(corner_at(ring, sector));
                list.PrimWriteVtx({middle.x - at.x * radius, middle.y + at.y * radius}, uv,
                                  colours[static_cast<std::size_t>(1 + (ring - 1) * sectors + sector)]);
            }
        const auto index = [&](int ring, int sector) {
            return static_cast<ImDrawIdx>(base +
                                          (ring == 0 ? 0 : 1 + (ring - 1) * sectors + sector % sectors));
        };
        for (int ring = 0; ring < rings; ++ring)
            for (int sector = 0; sector < sectors; ++sector) {
                for (const ImDrawIdx i :
                     {index(ring, sector), index(ring + 1, sector), index(ring + 1, sector + 1)})
                    list.PrimWriteIdx(i);
                if (ring == 0) continue;
                for (const ImDrawIdx i :
                     {index(ring, sector), index(ring + 1, sector + 1), index(ring, sector + 1)})
                    list.PrimWriteIdx(i);
            }
    }
    list.AddCircle(middle, radius, ImGui::GetColorU32(palette::text_dim), 32, 1);
}

}  // namespace nacre::ui
