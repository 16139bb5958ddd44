#include "app/designer/canvas_pane.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/designer/lit_picture.h"
#include "ui/canvas_tools.h"

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

// What the hand works on.
ui::CanvasSight sight_of(const Frame& frame, const ui::LayersView& layers) {
    return {.p = frame.p.get(),
            .mean = frame.p && !layers.solo ? std::optional(frame.p->mean()) : std::nullopt};
}

}  // namespace

// Only between drags: the disk must not shrink under the pointer.
void CanvasPane::show_below(const Frame& seen) {
    if (ImGui::IsAnyMouseDown()) return;
    const auto& layers = seen.design.distribution.layers;
    const bool below =
        seen.p && std::any_of(layers.begin(), layers.end(), layer_reaches_below) && shows_below(*seen.p);
    if (below == state.camera.below) return;
    state.camera.below = below;
    state.camera = state.camera.whole();
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

void CanvasPane::redraw(const FacetDistribution* p, const HemisphereView& view, const Drawn& wanted) {
    if (p != nullptr && scaled_revision_ != wanted.revision) scale_.peak = peak_density(*p);
    scaled_revision_ = wanted.revision;
    scale_.kind = wanted.scale;
    HemispherePicture picture = wanted.tables
                                    ? lit_picture(*wanted.tables, wanted.light, view, wanted.divisor)
                                    : density_picture(p, view, scale_, wanted.divisor);
    if (wanted.mask) veil_what_is_hidden(picture, view, wanted.divisor, *wanted.mask, wanted.mask_frame);
    picture_.store(picture.size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data(), GL_LINEAR);
    texels_ = picture.size;
    drawn_ = wanted;
}

void CanvasPane::work(const Frame& seen, Design& design, ui::LayersView& layers) {
    show_below(seen);
    corner_ = ImGui::GetWindowPos(), extent_ = ImGui::GetWindowSize();
    frame_ = ui::begin_canvas(state, sight_of(seen, layers), design.distribution, layers.chosen);
}

// Drawn at the framebuffer's pixels, of which a unit of the interface may have several.
HemisphereView CanvasPane::view() const {
    const auto pixels = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
    return {state.camera, frame_.view.size() * pixels};
}

bool CanvasPane::holds(ImVec2 at) const {
    const float x = at.x - corner_.x, y = at.y - corner_.y;
    return x >= 0 && y >= 0 && x < extent_.x && y < extent_.y;
}

void CanvasPane::update(const Frame& frame, const Scene& scene, std::size_t chosen) {
    const Distribution& distribution = frame.design.distribution;
    const HemisphereView seen = view();
    Drawn wanted{
        .revision = frame.revision, .camera = state.camera, .size = seen.size(), .scale = state.scale};
    if (state.scale == ScaleKind::material && frame.p && frame.tables) {
        wanted.tables = frame.tables;
        wanted.light = scene.light.irradiance * std::exp2(scene.exposure);
    }
    if (ui::part_in_hand(state, distribution, chosen) == LayerPart::mask) {
        wanted.mask = part_picture(distribution.layers[chosen], LayerPart::mask)->raster;
        wanted.mask_frame = layer_frame(distribution.layers[chosen]);
    }
    wanted.divisor = divisor(wanted);
    if ((frame.p || wanted.mask) && wanted != drawn_) redraw(frame.p.get(), seen, wanted);
}

void CanvasPane::draw(const Frame& frame, const Design& design, const ui::LayersView& layers,
                      const std::optional<dvec3>& marked) const {
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture_.name()));
    const double pixels = view().size().x / frame_.view.size().x;
    const glm::vec2 covered(glm::dvec2(texels_ * drawn_.divisor) / pixels);
    const bool masked = ui::part_in_hand(state, design.distribution, layers.chosen) == LayerPart::mask;
    ui::end_canvas(state, frame_,
                   {.design = &design.distribution,
                    .chosen = layers.chosen,
                    .p = frame.p.get(),
                    .picture = frame.p || masked ? texture : nullptr,
                    .picture_size = {covered.x, covered.y},
                    .scale = scale_,
                    .mean = sight_of(frame, layers).mean,
                    .marked = marked});
}

}  // namespace nacre
