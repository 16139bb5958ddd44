#include "app/designer/canvas_pane.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nacre {
namespace {

constexpr double rest_seconds = 0.12;     // without a change until every pixel is drawn
constexpr double samples_moving = 45000;  // of p in one frame, about 2 ms

// Whether a layer can hold facets below the horizon, as overhangs do.
bool layer_reaches_below(const Layer& layer) {
    if (!layer.enabled || layer.weight <= 0) return false;
    if (layer.tilt > 0) return true;
    return reaches_below(layer.lobe);
}

// Those of them that are worth an outer ring: a part in a hundred of the facets' area, seen from below.
bool shows_below(const FacetDistribution& p) { return p.projected_area({0, 0, -1}) > 0.01; }

}  // namespace

// Only between drags: the disk must not shrink under the pointer.
void CanvasPane::show_below(const Distribution& distribution) {
    if (ImGui::IsAnyMouseDown()) return;
    const FacetDistribution* p = live_.of(distribution);
    const auto& layers = distribution.layers;
    const bool below = p && std::any_of(layers.begin(), layers.end(), layer_reaches_below) && shows_below(*p);
    if (below != state.camera.below) state.camera = {.dome = state.camera.dome, .below = below};
}

std::optional<std::size_t> CanvasPane::strongest_layer(dvec3 h) const {
    const FacetDistribution* p = live_.newest();
    if (!p) return {};
    std::optional<std::size_t> strongest;
    double most = 0;
    for (const PlacedLobe& placed : p->lobes()) {
        const double density = placed.scale * placed.lobe->density(glm::transpose(placed.frame) * h);
        if (density > most) most = density, strongest = placed.layer;
    }
    return strongest;
}

int CanvasPane::divisor(const Drawn& wanted) {
    Drawn same = wanted;
    same.divisor = drawn_.divisor;
    const double now = ImGui::GetTime();
    if (same != drawn_) changed_at_ = now;
    const bool moving = now - changed_at_ < rest_seconds || ImGui::IsAnyMouseDown();
    if (insist_on_best_) return 1;
    // What has been drawn finely stays so until it changes.
    if (same == drawn_ && (moving || drawn_.divisor == 1)) return drawn_.divisor;
    if (!moving) return 1;
    return std::max(1,
                    static_cast<int>(std::ceil(std::sqrt(wanted.size.x * wanted.size.y / samples_moving))));
}

void CanvasPane::redraw(const FacetDistribution& p, const HemisphereView& view, const Drawn& wanted) {
    if (scaled_revision_ != wanted.revision) scale_.peak = peak_density(p);
    scaled_revision_ = wanted.revision;
    scale_.logarithmic = wanted.logarithmic;
    const DensityPicture picture = density_picture(p, view, scale_, wanted.divisor);
    picture_.store(picture.size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data(), GL_LINEAR);
    texels_ = picture.size;
    drawn_ = wanted;
}

void CanvasPane::draw(Design& design, ui::LayersView& layers, const std::function<void()>& edited) {
    show_below(ui::shown(layers, design.distribution));
    state.strongest_layer = [this](dvec3 h) { return strongest_layer(h); };
    const ui::CanvasFrame frame = ui::begin_canvas(state, design.distribution, layers.chosen);
    pointed_at_ = frame.cursor;
    edited();
    const FacetDistribution* p = live_.of(ui::shown(layers, design.distribution));
    state.mean = p && !layers.solo ? std::optional(p->mean()) : std::nullopt;
    // Drawn at the framebuffer's pixels, of which a unit of the interface may have several.
    const auto pixels = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
    const HemisphereView view(state.camera, frame.view.size() * pixels);
    Drawn wanted{.revision = live_.revision(),
                 .camera = state.camera,
                 .size = view.size(),
                 .logarithmic = state.logarithmic};
    wanted.divisor = divisor(wanted);
    if (p && wanted != drawn_) redraw(*p, view, wanted);
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture_.name()));
    const glm::vec2 covered(glm::dvec2(texels_ * drawn_.divisor) / pixels);
    ui::end_canvas(state, frame,
                   {.design = &design.distribution,
                    .chosen = layers.chosen,
                    .p = p,
                    .picture = p ? texture : nullptr,
                    .picture_size = {covered.x, covered.y},
                    .scale = scale_});
}

}  // namespace nacre
