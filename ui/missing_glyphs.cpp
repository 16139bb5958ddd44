#include "ui/missing_glyphs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nacre::ui {
namespace {

constexpr int box_rectangle = 0;       // of the atlas's own
constexpr float steps_a_texel = 2048;  // exact in a float, as texture sizes are powers of two
constexpr unsigned first = 0x80, last = 0xFFFD;

struct Range {
    unsigned first, last;
};
constexpr Range left_out[] = {{0xD800, 0xF8FF}};  // surrogates, private use
// Those that format text and have no form of their own: joiners, marks of direction, variants.
constexpr Range invisible[] = {{0xAD, 0xAD},     {0x200B, 0x200F}, {0x202A, 0x202E},
                               {0x2060, 0x206F}, {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}};

template <std::size_t N>
bool within(const Range (&ranges)[N], unsigned character) {
    return std::any_of(ranges, ranges + N, [&](const Range& range) {
        return range.first <= character && character <= range.last;
    });
}

void paint_box(ImFontAtlas& atlas, const ImFontAtlasCustomRect& box) {
    const int line = std::max(1, box.Height / 12);
    for (int y = 0; y < box.Height; ++y)
        for (int x = 0; x < box.Width; ++x) {
            const bool inside = x > 0 && y > 0 && x <= box.Width - 2 && y <= box.Height - 2;
            const bool hole = x > line && y > line && x <= box.Width - 2 - line && y <= box.Height - 2 - line;
            atlas.TexPixelsAlpha8[(box.Y + y) * atlas.TexWidth + box.X + x] = inside && !hole ? 255 : 0;
        }
}

void add_boxes(ImFont& font, const ImFontAtlas& atlas, const ImFontAtlasCustomRect& box) {
    const float width = box.Width, height = box.Height;
    const float u = 1 / static_cast<float>(atlas.TexWidth), v = 1 / static_cast<float>(atlas.TexHeight);
    const float bottom = std::round(font.Ascent);
    font.Glyphs.reserve(static_cast<int>(last));
    for (unsigned c = first; c <= last; ++c) {
        const auto character = static_cast<ImWchar>(c);
        if (within(left_out, c) || font.FindGlyphNoFallback(character) != nullptr) continue;
        if (within(invisible, c)) {
            font.AddGlyph(nullptr, character, 0, 0, 0, 0, 0, 0, 0, 0, 0);
            continue;
        }
        const float x = box.X + static_cast<float>(c & 255) / steps_a_texel;
        const float y = box.Y + static_cast<float>(c >> 8) / steps_a_texel;
        font.AddGlyph(nullptr, character, 0, bottom - height, width, bottom, x * u, y * v, (x + width) * u,
                      (y + height) * v, width);
    }
    font.FallbackChar = static_cast<ImWchar>(last);
    font.BuildLookupTable();
}

// One of 256 steps beyond the box's corner.
std::optional<unsigned> step_at(float texture, int size, int corner) {
    const float steps = (texture * static_cast<float>(size) - static_cast<float>(corner)) * steps_a_texel;
    if (steps < 0 || steps > 255 || steps != std::round(steps)) return std::nullopt;
    return static_cast<unsigned>(steps);
}

}  // namespace

void reserve_missing_box(ImFontAtlas& atlas, float text_size) {
    IM_ASSERT(atlas.CustomRects.empty());
    atlas.AddCustomRectRegular(static_cast<int>(std::round(text_size * 0.6f)),
                               static_cast<int>(std::round(text_size * 0.85f)));
}

void add_missing_boxes(ImFontAtlas& atlas) {
    const ImFontAtlasCustomRect& box = *atlas.GetCustomRectByIndex(box_rectangle);
    if (!box.IsPacked()) return;
    paint_box(atlas, box);
    for (ImFont* font : atlas.Fonts) add_boxes(*font, atlas, box);
}

std::vector<ImWchar> missing_characters(const ImDrawData& drawn) {
    const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    std::vector<ImWchar> found;
    if (atlas.CustomRects.empty()) return found;
    const ImFontAtlasCustomRect& box = atlas.CustomRects[box_rectangle];
    for (int i = 0; i < drawn.CmdListsCount; ++i)
        for (const ImDrawVert& vertex : drawn.CmdLists[i]->VtxBuffer) {
            const auto low = step_at(vertex.uv.x, atlas.TexWidth, box.X);
            const auto high = low ? step_at(vertex.uv.y, atlas.TexHeight, box.Y) : std::nullopt;
            if (high) found.push_back(static_cast<ImWchar>(*high * 256 + *low));
        }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace nacre::ui
