#include "app/designer/plots_pane.h"

#include <cstdint>

namespace nacre {
namespace {

constexpr int slice_side_moving = 91, slice_side_resting = 181;  // values along each side

}  // namespace

void PlotsPane::update(const std::shared_ptr<const Tables>& tables) {
    PlotSettings wanted = state.settings;
    wanted.slice_side = ImGui::IsAnyMouseDown() ? slice_side_moving : slice_side_resting;
    // What has been drawn finely stays so until it changes.
    if (settings_.slice_side == slice_side_resting && plotted_ == tables) {
        PlotSettings finely = wanted;
        finely.slice_side = slice_side_resting;
        if (finely == settings_) return;
    }
    if (plotted_ == tables && settings_ == wanted) return;
    plotted_ = tables;
    settings_ = wanted;
    plot_ = tables ? make_plot(*tables, settings_) : std::nullopt;
    if (!plot_) return;
    if (const auto* slice = std::get_if<SlicePlot>(&plot_->contents)) {
        const PlotPixels pixels = slice_pixels(*slice);
        std::vector<std::uint8_t> rgba;
        rgba.reserve(4 * pixels.colours.size());
        for (const glm::u8vec3& c : pixels.colours) rgba.insert(rgba.end(), {c.x, c.y, c.z, 255});
        slice_.store(pixels.size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data(), GL_LINEAR);
    }
}

void PlotsPane::draw(const std::shared_ptr<const Tables>& tables, const std::string& name,
                     const std::optional<DialogProgram>& dialogs) {
    update(tables);
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(slice_.name()));
    const ui::PlotsAnswer answer = ui::plots_panel(
        state, {.plot = plot_ ? &*plot_ : nullptr, .waiting = "baking\u2026", .slice = texture});
    reading_ = answer.reading;
    if (!answer.save || !plot_) return;
    PlotSettings saved = settings_;
    saved.slice_side = PlotSettings{}.slice_side;  // a file as the command line makes it
    saving.ask(*make_plot(*plotted_, saved), state.view, name + "-" + name_of(saved.kind) + ".svg", dialogs);
}

}  // namespace nacre
