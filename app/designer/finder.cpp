#include "app/designer/finder.h"

#include <string>
#include <utility>
#include <vector>

#include "app/designer/command.h"
#include "core/model/kinds/kind.h"
#include "core/paint/lobe_handles.h"
#include "ui/canvas_tools.h"
#include "ui/item_map.h"

namespace nacre {
namespace {

void add_commands(const Designer& designer, std::vector<Finding>& list) {
    const std::vector<ui::CommandState> states = command_states(designer);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const ui::CommandInfo& info = *states[i].info;
        if (!states[i].enabled || info.label == nullptr) continue;
        const std::string keys = info.keys != nullptr ? info.keys : "";
        const std::string about = info.about != nullptr ? info.about : "";
        if (!states[i].choices) {
            list.push_back({{info.label, info.menu, keys, about}, [i](Designer& to) {
                                perform(to, ui::Order{i, 0});
                            }});
            continue;
        }
        for (std::size_t which = 0; which < states[i].choices->size(); ++which) {
            const ui::CommandChoice& choice = (*states[i].choices)[which];
            list.push_back({{choice.label, info.menu, "", choice.about}, [i, which](Designer& to) {
                                perform(to, ui::Order{i, which});
                            }});
        }
    }
}

void add_tools(std::vector<Finding>& list) {
    for (const ui::ToolEntry& tool : ui::canvas_tools())
        list.push_back({{tool.face->name, "Tool", std::string(1, tool.face->key), tool.face->about},
                        [&tool](Designer& to) { to.canvas.state.tool = tool.tool; }});
}

void add_presets(const Designer& designer, std::vector<Finding>& list) {
    for (const Preset& preset : designer.presets)
        list.push_back(
            {{preset.name, preset.is_start ? "Highlight" : "Preset", "", "Begin a new design as this."},
             [file = preset.file](Designer& to) { to.files.take_preset(to.document, file); }});
}

struct Setting {
    const char* label;  // of its widget, as "text##name"
    const char* panel;
    const char* about;
    bool of_expert = false;  // shown among all numbers alone
};

void add_setting(const Setting& setting, std::vector<Finding>& list) {
    const auto act = [setting](Designer& to) {
        to.panels = true;
        to.open_tab = setting.panel;
        to.layers.expert |= setting.of_expert;
    };
    list.push_back({{std::string(ui::visible_text(setting.label)), setting.panel, "", setting.about},
                    act,
                    std::string(ui::item_name(setting.label))});
}

// The numbers and colours of the kind that is chosen.
template <class Variant>
void add_parameters(const Variant& value, const char* panel, bool of_expert, std::vector<Finding>& list) {
    std::visit(
        [&]<class T>(const T&) {
            visit_parameters<T>([&](const auto& parameter) {
                if constexpr (requires { parameter.text.tooltip; })
                    add_setting({parameter.text.label, panel, parameter.text.tooltip, of_expert}, list);
            });
        },
        value);
}

constexpr const char* of_layer = "Of the chosen layer.";
constexpr const char* of_light = "What the object is lit by and stands before.";
constexpr const char* opens = "Opens this panel.";
constexpr Setting plain_settings[] = {{"Layers", "Layers", opens},
                                      {"Material", "Material", opens},
                                      {"Light", "Light", opens},
                                      {"Compare", "Compare", opens},
                                      {"Presets", "Presets", opens},
                                      {"Intensity", "Layers", "How bright the whole highlight is."},
                                      {"Weight", "Layers", of_layer},
                                      {"Colour##Layer tint", "Layers", of_layer},
                                      {"Direction##Rotation", "Layers", of_layer},
                                      {"Paint the mask", "Layers", of_layer},
                                      {"Tilt", "Layers", of_layer, true},
                                      {"Azimuth", "Layers", of_layer, true},
                                      {"Environment", "Light", of_light},
                                      {"Exposure", "Light", of_light},
                                      {"Background", "Light", of_light},
                                      {"Second light", "Light", of_light},
                                      {"Rim light", "Light", of_light},
                                      {"Ambient light", "Light", of_light}};

void add_settings(const Designer& designer, std::vector<Finding>& list) {
    const Design& design = designer.document.design;
    for (const Setting& setting : plain_settings) add_setting(setting, list);
    const auto& layers = design.distribution.layers;
    if (designer.layers.chosen < layers.size()) {
        const Lobe& lobe = layers[designer.layers.chosen].lobe;
        const bool has_shape = shape_of(lobe).has_value();
        if (has_shape)
            for (const char* label : {"Softness", "Stretch"}) add_setting({label, "Layers", of_layer}, list);
        add_parameters(lobe, "Layers", has_shape, list);
    }
    add_parameters(design.fresnel, "Material", false, list);
    add_parameters(design.diffuse, "Material", false, list);
    add_parameters(design.multibounce, "Material", false, list);
    add_parameters(design.shadowing.model, "Material", false, list);
    add_parameters(design.coat, "Material", false, list);
}

}  // namespace

std::vector<Finding> findings(const Designer& designer) {
    std::vector<Finding> list;
    add_commands(designer, list);
    add_tools(list);
    add_presets(designer, list);
    add_settings(designer, list);
    return list;
}

void draw_finder(Designer& designer) {
    const std::vector<Finding> list = findings(designer);
    std::vector<ui::SearchEntry> entries;
    for (const Finding& finding : list) entries.push_back(finding.entry);
    const ui::SearchAnswer answer = ui::command_search(*designer.search, entries);
    if (!answer.closed) return;
    designer.search.reset();
    if (answer.chosen) list[*answer.chosen].act(designer);
}

}  // namespace nacre
