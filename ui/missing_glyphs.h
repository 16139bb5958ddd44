// A box for every character that the fonts lack, and which of them were shown: the texture coordinates of
// each box are its own, by less than an eighth of a pixel, so that what was drawn names the characters,
// wherever the text came from.
#pragma once

#include <imgui.h>

#include <vector>

namespace nacre::ui {

// Before the atlas is built: makes room for the box. It has to be the first of the atlas's own rectangles.
void reserve_missing_box(ImFontAtlas& atlas, float text_size);

// After it is built, for each of its fonts.
void add_missing_boxes(ImFontAtlas& atlas);

// The characters without a glyph in what was drawn with the current context's fonts, in order, each once.
std::vector<ImWchar> missing_characters(const ImDrawData& drawn);

}  // namespace nacre::ui
