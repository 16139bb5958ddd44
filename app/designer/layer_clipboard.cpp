#include "app/designer/layer_clipboard.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <exception>
#include <iterator>

#include "app/designer/designer.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/design/design_file.h"
#include "ui/layer_list.h"

namespace nacre {
namespace {

constexpr const char* clipboard_name = "the clipboard";

std::string title_of(const Layer& layer) { return layer.name.empty() ? kind_label(layer.lobe) : layer.name; }

// A cheap look, so that what was never meant for Nacre is not complained about in detail.
bool is_foreign(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == text.npos || text[first] != '{' || text.find("\"nacre\"") == text.npos;
}

Layer* chosen_layer(Designer& designer) {
    auto& layers = designer.document.design.distribution.layers;
    return designer.layers.chosen < layers.size() ? &layers[designer.layers.chosen] : nullptr;
}

// Returns whether it is there now.
bool to_clipboard(Designer& designer, const Layer& layer) {
    try {
        ImGui::SetClipboardText(layer_text(layer).c_str());
        return true;
    } catch (const std::exception&) {
        designer.files.tell("Cannot copy: " + plain_words(std::current_exception()));
        return false;
    }
}

}  // namespace

std::string layer_text(const Layer& layer) {
    Design design;
    design.name = layer.name;
    design.distribution.layers = {layer};
    std::string text = portable_design_json(design);
    if (text.size() > clipboard_bytes_max)
        throw UserError("", "layer", "its pictures are larger than the 15 MB that the clipboard holds",
                        fmt::format("{:.1f} MB", static_cast<double>(text.size()) / (1 << 20)));
    return text;
}

std::vector<Layer> layers_of_text(std::string_view text, std::size_t room) {
    text = without_byte_order_mark(text);
    if (is_foreign(text)) throw UserError("", "", "The clipboard holds no layers of Nacre");
    if (text.size() > limits::file_bytes_max)
        throw UserError(clipboard_name, "read", "it holds more text than a design may have");
    std::vector<Layer> layers = parse_work(text, clipboard_name, "/").distribution.layers;
    if (layers.size() > room)
        throw UserError("", "layers", fmt::format("a design holds no more than {}", int{limits::layers_max}),
                        fmt::format("{} more", layers.size()));
    return layers;
}

void copy_layer(Designer& designer) {
    const Layer* layer = chosen_layer(designer);
    if (layer && to_clipboard(designer, *layer)) designer.files.tell("Copied " + title_of(*layer));
}

void cut_layer(Designer& designer) {
    const Layer* layer = chosen_layer(designer);
    if (!layer) return;
    auto& layers = designer.document.design.distribution.layers;
    if (!ui::possible(ui::LayerAction::remove, designer.layers.chosen, layers.size())) {
        designer.files.tell("A design needs at least one layer: copy it instead");
        return;
    }
    const std::string title = title_of(*layer);
    if (!to_clipboard(designer, *layer)) return;
    ui::act(ui::LayerAction::remove, designer.layers, layers);
    designer.files.tell("Cut " + title);
}

void paste_layer(Designer& designer) {
    auto& layers = designer.document.design.distribution.layers;
    try {
        const char* text = ImGui::GetClipboardText();
        std::vector<Layer> pasted =
            layers_of_text(text != nullptr ? text : "", limits::layers_max - layers.size());
        const std::size_t at = layers.empty() ? 0 : std::min(designer.layers.chosen + 1, layers.size());
        designer.files.tell("Pasted " + title_of(pasted.front()));
        designer.layers.chosen = at + pasted.size() - 1;
        layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(at),
                      std::make_move_iterator(pasted.begin()), std::make_move_iterator(pasted.end()));
    } catch (const UserError& error) {
        designer.files.tell(error.where.empty() ? error.problem + "."
                                                : "Cannot paste: " + one_line(error.what()));
    } catch (const std::exception&) {
        designer.files.tell("Cannot paste: " + problem_line());
    }
}

}  // namespace nacre
