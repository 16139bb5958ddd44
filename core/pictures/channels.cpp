#include "core/pictures/channels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "core/base/error.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// The channels of one layer by what they mean; -1 where there is none.
struct Layer {
    int red = -1, green = -1, blue = -1, grey = -1, alpha = -1, chroma = -1, others = 0;

    bool has_colours() const { return red >= 0 && green >= 0 && blue >= 0; }
    void add(const std::string& name, int index) {
        const auto is = [&](std::initializer_list<const char*> names) {
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        int* const place = is({"r", "red"})                                   ? &red
                           : is({"g", "green"})                               ? &green
                           : is({"b", "blue"})                                ? &blue
                           : is({"y", "l", "i", "luminance", "gray", "grey"}) ? &grey
                           : is({"a", "alpha"})                               ? &alpha
                           : is({"ry", "by"})                                 ? &chroma
                                                                              : nullptr;
        if (place == nullptr || *place >= 0)
            ++others;
        else
            *place = index;
    }
    int known() const {
        return static_cast<int>((red >= 0) + (green >= 0) + (blue >= 0) + (grey >= 0) + (alpha >= 0));
    }
};

// Nothing where the layer is not plainly a picture.
std::vector<int> colour_of(const Layer& layer, PictureUse use) {
    if (layer.has_colours()) return {layer.red, layer.green, layer.blue};
    if (layer.grey >= 0 && layer.chroma < 0) return {layer.grey};
    if (layer.red >= 0 && layer.green >= 0 && use == PictureUse::data) return {layer.red, layer.green};
    if (layer.red >= 0 && layer.green < 0 && layer.blue < 0 && layer.others == 0) return {layer.red};
    return {};
}

bool names_finished_picture(const std::string& layer) {
    const std::string last = layer.substr(layer.rfind('.') + 1);
    for (const std::string_view known :
         {"beauty", "combined", "composite", "rgba", "rgb", "color", "colour", "image"})
        if (last == known) return true;
    return false;
}

std::string list(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 12;
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), shown));
    std::string text = fmt::format("{}", fmt::join(names.begin(), end, ", "));
    if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
    return one_line(text, 300);
}

}  // namespace

Channels choose_channels(const std::vector<std::string>& names, PictureUse use, bool named) {
    std::map<std::string, Layer> layers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string name = lower_case(names[i]);
        const std::size_t dot = name.rfind('.');
        layers[dot == name.npos ? "" : name.substr(0, dot)].add(
            dot == name.npos ? name : name.substr(dot + 1), static_cast<int>(i));
    }
    const Layer* chosen = &layers[""];
    std::vector<int> colour = colour_of(*chosen, use);
    if (colour.empty() && chosen->known() == 0) {
        std::vector<const Layer*> finished;
        for (const auto& [name, layer] : layers)
            if (names_finished_picture(name) && layer.has_colours()) finished.push_back(&layer);
        if (finished.size() == 1) colour = colour_of(*(chosen = finished[0]), use);
    }
    if (colour.empty() && !named && names.size() == 1) colour = {0};
    if (colour.empty())
        throw PictureProblem(
            fmt::format("its channels are {}: none is plainly the picture's colour, which R, G and "
                        "B or Y are",
                        list(names)));
    Channels result{colour, chosen->alpha, {}};
    if (names.size() > colour.size() + (chosen->alpha >= 0 ? 1 : 0)) {
        std::vector<std::string> used, left;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto channel = static_cast<int>(i);
            if (std::find(colour.begin(), colour.end(), channel) != colour.end())
                used.push_back(names[i]);
            else if (channel != chosen->alpha)
                left.push_back(names[i]);
        }
        result.note = fmt::format("its channels {} are used, {} are not", list(used), list(left));
    }
    return result;
}

}  // namespace nacre
