// What a picture that comes in is for: one card for each use, which shows what would come of it.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace nacre::ui {

struct ImportCard {
    const char* name;
    const char* about;
    ImTextureID picture = nullptr;  // square; null while there is none
    std::string refusal = {};       // why the picture cannot be used so; empty where it can
};

struct ImportContents {
    std::string name;  // of the picture
    std::span<const ImportCard> cards;
    std::size_t likely = 0;  // of the cards
    std::string why;         // it is, "it is mostly blue"
    std::string remark;      // on the picture, as the chosen card uses it
};

enum class ImportAnswer { none, accepted, cancelled };

// The dialog. Left and right choose, as a click does; Enter and a double click accept, Escape cancels.
// `fields` draws the settings of the chosen card. A card is found by scripts as "As NAME".
ImportAnswer import_dialog(const ImportContents& contents, std::size_t& chosen,
                           const std::function<void()>& fields);

}  // namespace nacre::ui
