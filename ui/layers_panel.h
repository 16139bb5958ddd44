// The layers of the distribution: a list, and the chosen layer's parameters.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/design/design.h"
#include "ui/curve_editor.h"
#include "ui/layer_thumbnail.h"

namespace nacre::ui {

// What the list's menu asks for: the clipboard is not known here.
enum class ClipboardAction { cut, copy, paste };

// What the panel remembers between frames; no part of the document.
struct LayersView {
    std::size_t chosen = 0;
    std::optional<std::size_t> solo;  // a layer that is shown alone; ends where layers come, go or move
    std::size_t count = 0;            // of layers in the frame before
    struct Rename {
        std::size_t layer = 0;
        bool begun = false;  // the field has the keyboard
    };
    std::optional<Rename> rename;          // in the list
    std::optional<ClipboardAction> asked;  // of the chosen layer, to be done by the caller
    bool carried = false;                  // the chosen layer, by the pointer to another place of the list
    bool linked = false;                   // the widths along x and y keep their ratio
    bool expert = true;                    // all numbers show, and not only what an artist calls them
    // Settings that a layer is to be made with again from its picture. Whoever does it takes this back.
    struct Remake {
        std::size_t layer = 0;
        PictureSource source;
        bool operator==(const Remake&) const = default;
    };
    std::optional<Remake> remake;
    struct SourceTrouble {
        std::filesystem::path image;
        std::string words;  // why nothing can be made of it
    };
    std::optional<SourceTrouble> source_trouble;
    LayerThumbnails thumbnails;
    CurveView curve;
};

// The layers as they are shown: all of them, or with one alone.
Distribution shown(const LayersView& view, const Distribution& distribution);

// Returns whether the distribution changed. `paints_mask`: see CanvasState.
bool layers_panel(LayersView& view, Distribution& distribution, bool& paints_mask);

// The parameters of one layer.
bool layer_editor(Layer& layer, LayersView& view, bool& paints_mask);

// Of the chosen layer, where its raster was made from a picture: the settings, which view.remake follows.
void source_editor(const Layer& layer, LayersView& view);

}  // namespace nacre::ui
