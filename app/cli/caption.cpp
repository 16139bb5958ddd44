#include "app/cli/caption.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/utf8.h"
#include "ui/fonts.h"

namespace nacre::cli {
namespace {

constexpr int oversampling = 2;
constexpr ImWchar letters[] = {0x20,   0x24F,  0x370, 0x52F,
                               0x2010, 0x2027, 0};  // Latin, Greek, Cyrillic, marks

// What lies beyond the letters of the typeface becomes its replacement.
std::vector<ImWchar> characters_of(const std::string& text) {
    std::vector<ImWchar> characters;
    for (const char32_t code : code_points(text))
        characters.push_back(static_cast<ImWchar>(code <= 0xFFFF ? code : 0xFFFD));
    return characters;
}

double advance(const ImFont& font, ImWchar code) {
    return static_cast<double>(font.FindGlyph(code)->AdvanceX) / oversampling;
}

double text_width(const ImFont& font, const std::vector<ImWchar>& codes) {
    double sum = 0;
    for (const ImWchar code : codes) sum += advance(font, code);
    return sum;
}

// As much of the text as fits, with an ellipsis where some is left out.
void shorten(std::vector<ImWchar>& codes, const ImFont& font, double width_max) {
    constexpr ImWchar ellipsis = 0x2026;
    const double room = width_max - advance(font, ellipsis);
    double width = 0;
    std::size_t fits = 0;  // with an ellipsis after them
    for (std::size_t i = 0; i < codes.size() && width <= width_max; ++i) {
        width += advance(font, codes[i]);
        if (width <= room) fits = i + 1;
    }
    if (width <= width_max) return;
    codes.resize(fits);
    codes.push_back(ellipsis);
}

void blend(RenderedImage& image, int x, int y, float coverage, float grey) {
    if (x < 0 || y < 0 || x >= image.size.x || y >= image.size.y) return;
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
                                static_cast<std::size_t>(x));
    for (std::size_t c = 0; c < 3; ++c) image.rgb[at + c] += coverage * (grey - image.rgb[at + c]);
}

}  // namespace

CaptionFont::CaptionFont(int pixels) : atlas_(std::make_unique<ImFontAtlas>()) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.SizePixels = static_cast<float>(oversampling * pixels);
    config.OversampleH = 1;
    const std::span<const unsigned char> file = ui::font_regular();
    if (file.empty()) {
        atlas_->AddFontDefault(&config);
    } else {
        // Dear ImGui takes the font's bytes as writable and leaves them as they are.
        atlas_->AddFontFromMemoryTTF(const_cast<unsigned char*>(file.data()), static_cast<int>(file.size()),
                                     config.SizePixels, &config, letters);
    }
    atlas_->Build();
}

CaptionFont::~CaptionFont() = default;

void CaptionFont::draw(RenderedImage& image, const std::string& utf8, double x, int y, double width_max,
                       float grey) const {
    const ImFont& font = *atlas_->Fonts[0];
    std::vector<ImWchar> codes = characters_of(utf8);
    shorten(codes, font, width_max);
    unsigned char* texels = nullptr;
    int columns = 0, rows = 0;
    atlas_->GetTexDataAsAlpha8(&texels, &columns, &rows);
    double pen = oversampling * (x - 0.5 * text_width(font, codes));
    for (const ImWchar code : codes) {
        const ImFontGlyph& glyph = *font.FindGlyph(code);
        const int left = static_cast<int>(std::lround(pen + static_cast<double>(glyph.X0)));
        const int top = oversampling * y + static_cast<int>(std::lround(glyph.Y0));
        const int u = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(columns)));
        const int v = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(rows)));
        const int width = static_cast<int>(std::lround(glyph.X1 - glyph.X0));
        const int height = static_cast<int>(std::lround(glyph.Y1 - glyph.Y0));
        for (int j = 0; glyph.Visible && j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const float coverage = static_cast<float>(texels[(v + j) * columns + u + i]) / 255.0f;
                blend(image, (left + i) / oversampling, (top + j) / oversampling,
                      coverage / static_cast<float>(oversampling * oversampling), grey);
            }
        pen += static_cast<double>(glyph.AdvanceX);
    }
}

}  // namespace nacre::cli
