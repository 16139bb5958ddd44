// How the designer looks: colours, spacing and fonts.
#pragma once

#include <imgui.h>

#include <span>
#include <vector>

namespace nacre::ui {

// Dear ImGui's own vector has no constexpr constructor.
struct Colour {
    float r, g, b, a;
    operator ImVec4() const { return {r, g, b, a}; }
};

namespace palette {
inline constexpr Colour text{0.86f, 0.87f, 0.89f, 1};
inline constexpr Colour text_dim{0.56f, 0.58f, 0.62f, 1};
inline constexpr Colour window{0.125f, 0.130f, 0.142f, 1};
inline constexpr Colour canvas{0.090f, 0.094f, 0.103f, 1};
inline constexpr Colour field{0.185f, 0.192f, 0.210f, 1};
inline constexpr Colour field_hovered{0.225f, 0.233f, 0.255f, 1};
inline constexpr Colour line{0.215f, 0.222f, 0.240f, 1};
inline constexpr Colour accent{0.46f, 0.72f, 0.70f, 1};
inline constexpr Colour accent_bright{0.58f, 0.83f, 0.80f, 1};
inline constexpr Colour accent_dim{0.235f, 0.345f, 0.345f, 1};
inline constexpr Colour green{0.45f, 0.80f, 0.45f, 1};
inline constexpr Colour amber{0.93f, 0.73f, 0.42f, 1};
inline constexpr Colour red{0.94f, 0.50f, 0.46f, 1};
}  // namespace palette

// An OpenType file for characters that the embedded fonts lack. Its bytes outlive the atlas.
struct ExtraFont {
    std::span<const unsigned char> bytes;
    int face;                     // of those in the file
    std::vector<ImWchar> ranges;  // pairs of first and last character, and a 0
};

// Sets style and fonts of the current context for a scale of 1 at 96 dots per inch. A unit of the interface
// is `pixels` of the framebuffer: letters are drawn that fine. To be called before the renderer uploads the
// font texture. What neither the embedded fonts nor `extra` have is shown as a box: see missing_glyphs.h.
void apply_theme(float scale, float pixels = 1, std::span<const ExtraFont> extra = {});

// The heavier face for headings.
ImFont* heading_font();

// A length that is `pixels` at a scale of 1, at the current scale.
float scaled(float pixels);

}  // namespace nacre::ui
