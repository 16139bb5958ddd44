#include "app/designer/preset_wall.h"

#include <imgui.h>

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "app/designer/designer.h"
#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/design/design_file.h"
#include "core/paint/painted_layer.h"
#include "ui/presets_panel.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr float start_ems = 4.2f;    // width of the tiles of starts
constexpr double added_share = 0.5;  // weight of layers that are added, of those that were there

void add(Designer& designer, const Preset& preset) {
    try {
        Distribution& distribution = designer.document.design.distribution;
        add_layers(distribution, load_design(preset.file).distribution, preset.name);
        designer.layers.chosen = distribution.layers.size() - 1;
    } catch (const std::exception&) {
        designer.files.report(problem_line());
    }
}

// Those that are starts, or the others.
ui::PresetChoice draw_some(Designer& designer, bool starts) {
    std::vector<ui::PresetTile> tiles;
    std::vector<std::size_t> places;
    std::optional<std::size_t> current;
    for (std::size_t i = 0; i < designer.presets.size(); ++i) {
        const Preset& preset = designer.presets[i];
        if (preset.is_start != starts) continue;
        if (preset.file == designer.document.preset) current = tiles.size();
        tiles.push_back({preset.name, designer.thumbnails.texture(preset.file)});
        places.push_back(i);
    }
    ui::PresetChoice choice = starts ? ui::presets_panel(tiles, current, "Highlight", start_ems)
                                     : ui::presets_panel(tiles, current);
    for (auto* index : {&choice.hovered, &choice.begun, &choice.added})
        if (*index) *index = places[**index];
    return choice;
}

void follow_thumbnails(Designer& designer) {
    std::vector<Thumbnails::Wanted> wanted;
    for (const Preset& preset : designer.presets)
        wanted.push_back({preset.file, [file = preset.file] { return load_design(file); }});
    designer.thumbnails.follow(wanted);
}

}  // namespace

void add_layers(Distribution& distribution, const Distribution& added, const std::string& name) {
    constexpr auto none = static_cast<std::size_t>(-1);
    if (distribution.layers.size() + added.layers.size() > limits::layers_max)
        throw UserError("", "layers", "a design holds no more layers", std::to_string(limits::layers_max));
    const double there = weight_of_others(distribution, none), coming = weight_of_others(added, none);
    for (Layer layer : added.layers) {
        if (there > 0 && coming > 0) layer.weight *= added_share * there / coming;
        if (layer.name.empty()) layer.name = name;
        distribution.layers.push_back(std::move(layer));
    }
}

void draw_presets(Designer& designer) {
    follow_thumbnails(designer);
    ui::heading("Start from a highlight");
    ui::PresetChoice choice = draw_some(designer, true);
    ImGui::Spacing();
    ui::heading("Materials");
    const ui::PresetChoice material = draw_some(designer, false);
    if (material.hovered || material.begun || material.added) choice = material;
    if (choice.hovered) designer.pointed_preset = designer.presets[*choice.hovered].file;
    if (choice.begun) designer.files.take_preset(designer.document, designer.presets[*choice.begun].file);
    if (choice.added) add(designer, designer.presets[*choice.added]);
}

// One that cannot be read is told when it is clicked.
void follow_trial(Designer& designer) {
    const auto pointed = std::exchange(designer.pointed_preset, std::nullopt);
    if (designer.trial && pointed == designer.trial->file) return;
    designer.trial.reset();
    try {
        if (pointed) designer.trial = Trial{*pointed, load_design(*pointed)};
    } catch (const std::exception&) {
    }
}

}  // namespace nacre
