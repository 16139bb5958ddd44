#include "app/designer/finder.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/designer/command.h"
#include "core/model/kinds/kind.h"
#include "ui/canvas_tools.h"

namespace nacre {
namespace {

struct Finding {
    ui::SearchEntry entry;
    std::function<void(Designer&)> act;
};

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

void add_setting(const char* label, const char* panel, const char* about, std::vector<Finding>& list) {
    list.push_back({{label, panel, "", about}, [panel](Designer& to) {
                        to.panels = true;
                        to.open_tab = panel;
                    }});
}

// The parameters of the kind that is chosen.
template <class Variant>
void add_parameters(const Variant& value, const char* panel, std::vector<Finding>& list) {
    std::visit(
        [&]<class T>(const T&) {
            visit_parameters<T>([&](const auto& parameter) {
                if constexpr (requires { parameter.text.label; })
                    add_setting(parameter.text.label, panel, parameter.text.tooltip, list);
            });
        },
        value);
}

void add_settings(const Designer& designer, std::vector<Finding>& list) {
    const Design& design = designer.document.design;
    for (const char* panel : {"Layers", "Material", "Light", "Compare", "Presets"})
        add_setting(panel, panel, "Opens this panel.", list);
    const auto& layers = design.distribution.layers;
    if (designer.layers.chosen < layers.size())
        add_parameters(layers[designer.layers.chosen].lobe, "Layers", list);
    for (const char* label : {"Softness", "Stretch", "Weight", "Direction", "Tilt", "Azimuth"})
        add_setting(label, "Layers", "Of the chosen layer.", list);
    add_parameters(design.fresnel, "Material", list);
    add_parameters(design.diffuse, "Material", list);
    add_parameters(design.shadowing.model, "Material", list);
    for (const char* label : {"Environment", "Exposure", "Background", "Lights"})
        add_setting(label, "Light", "What the object is lit by and stands before.", list);
}

}  // namespace

void draw_finder(Designer& designer) {
    std::vector<Finding> list;
    add_commands(designer, list);
    add_tools(list);
    add_presets(designer, list);
    add_settings(designer, list);
    std::vector<ui::SearchEntry> entries;
    for (const Finding& finding : list) entries.push_back(finding.entry);
    const ui::SearchAnswer answer = ui::command_search(*designer.search, entries);
    if (!answer.closed) return;
    designer.search.reset();
    if (answer.chosen) list[*answer.chosen].act(designer);
}

}  // namespace nacre
