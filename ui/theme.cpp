#include "ui/theme.h"

#include <cmath>

#include "ui/fonts.h"
#include "ui/missing_glyphs.h"

namespace nacre::ui {
namespace {

constexpr float text_size = 15;  // pixels at scale 1

// What labels, file names and layer names of most European languages need, with the signs of the
// mathematics: Greek, arrows, operators, shapes.
constexpr ImWchar glyph_ranges[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x052F, 0x1E00,
                                    0x1EFF, 0x2010, 0x2044, 0x2070, 0x209F, 0x2190, 0x21FF,
                                    0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

void add_file(std::span<const unsigned char> bytes, float size, ImFontConfig config, const ImWchar* ranges) {
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = 2;
    config.OversampleV = 1;
    // The atlas takes a pointer to non-const only because it may own the bytes.
    void* data = const_cast<unsigned char*>(bytes.data());
    ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()), size, &config, ranges);
}

void add_font(std::span<const unsigned char> bytes, float size, std::span<const ExtraFont> extra) {
    if (bytes.empty())
        ImGui::GetIO().Fonts->AddFontDefault();
    else
        add_file(bytes, size, {}, glyph_ranges);
    for (const ExtraFont& font : extra) {
        ImFontConfig config;
        config.MergeMode = true;
        config.FontNo = font.face;
        add_file(font.bytes, size, config, font.ranges.data());
    }
}

void set_spacing(ImGuiStyle& style) {
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 5};
    style.ItemSpacing = {8, 7};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {6, 4};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.ChildRounding = 4;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 6;
    style.GrabRounding = 3;
    style.TabRounding = 4;
    style.WindowTitleAlign = {0.02f, 0.5f};
    style.DisabledAlpha = 0.42f;
}

void set_field_colours(ImGuiStyle& style) {
    using namespace palette;
    ImVec4* c = style.Colors;
    c[ImGuiCol_FrameBg] = field;
    c[ImGuiCol_FrameBgHovered] = field_hovered;
    c[ImGuiCol_FrameBgActive] = field_hovered;
    c[ImGuiCol_CheckMark] = accent_bright;
    c[ImGuiCol_SliderGrab] = accent;
    c[ImGuiCol_SliderGrabActive] = accent_bright;
    c[ImGuiCol_Button] = field;
    c[ImGuiCol_ButtonHovered] = field_hovered;
    c[ImGuiCol_ButtonActive] = accent_dim;
    c[ImGuiCol_Header] = accent_dim;
    c[ImGuiCol_HeaderHovered] = field_hovered;
    c[ImGuiCol_HeaderActive] = accent_dim;
    c[ImGuiCol_Tab] = window;
    c[ImGuiCol_TabHovered] = field_hovered;
    c[ImGuiCol_TabActive] = field;
    c[ImGuiCol_TextSelectedBg] = {0.30f, 0.45f, 0.45f, 1};
    c[ImGuiCol_DragDropTarget] = accent_bright;
    c[ImGuiCol_NavHighlight] = accent;
    c[ImGuiCol_PlotHistogram] = accent_dim;
}

void set_window_colours(ImGuiStyle& style) {
    using namespace palette;
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = text;
    c[ImGuiCol_TextDisabled] = text_dim;
    c[ImGuiCol_WindowBg] = window;
    c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
    c[ImGuiCol_PopupBg] = {0.150f, 0.156f, 0.170f, 1};
    c[ImGuiCol_Border] = {0.27f, 0.28f, 0.30f, 1};
    c[ImGuiCol_MenuBarBg] = {0.105f, 0.110f, 0.120f, 1};
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = {0.105f, 0.110f, 0.120f, 1};
    c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    c[ImGuiCol_ScrollbarGrab] = line;
    c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = {0.30f, 0.31f, 0.34f, 1};
    c[ImGuiCol_Separator] = line;
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = accent;
    c[ImGuiCol_ResizeGrip] = c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = {0, 0, 0, 0};
    c[ImGuiCol_TableHeaderBg] = window;
    c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = line;
    c[ImGuiCol_TableRowBgAlt] = {1, 1, 1, 0.02f};
    c[ImGuiCol_ModalWindowDimBg] = {0.04f, 0.04f, 0.05f, 0.55f};
}

}  // namespace

void apply_theme(float scale, float pixels, std::span<const ExtraFont> extra) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    set_spacing(style);
    set_window_colours(style);
    set_field_colours(style);
    style.ScaleAllSizes(scale);
    style.PopupBorderSize = 1;

    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.TexGlyphPadding = 1;
    const float size = std::round(text_size * scale * pixels);
    reserve_missing_box(atlas, size);
    add_font(font_regular(), size, extra);
    add_font(font_semibold(), size, extra);
    atlas.Build();
    add_missing_boxes(atlas);
    ImGui::GetIO().FontGlobalScale = 1 / pixels;
}

ImFont* heading_font() { return ImGui::GetIO().Fonts->Fonts.back(); }

float scaled(float pixels) { return std::round(pixels * ImGui::GetFontSize() / text_size); }

}  // namespace nacre::ui
