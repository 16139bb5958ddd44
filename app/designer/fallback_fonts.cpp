#include "app/designer/fallback_fonts.h"

#include <fontconfig/fontconfig.h>
#include <stb/stb_truetype.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "ui/fonts.h"

namespace nacre {
namespace {

constexpr int face_bits = 0xFFFF;  // of fontconfig's index; the rest is an instance of a variable font

template <class T, void (*destroy)(T*)>
struct Destroy {
    void operator()(T* object) const { destroy(object); }
};
using Pattern = std::unique_ptr<FcPattern, Destroy<FcPattern, FcPatternDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, Destroy<FcFontSet, FcFontSetDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Destroy<FcCharSet, FcCharSetDestroy>>;

// Fonts with outlines that draw these characters, the fittest first.
FontSet sorted_fonts(FcConfig* config, const std::vector<ImWchar>& characters) {
    const CharSet set(FcCharSetCreate());
    for (const ImWchar character : characters) FcCharSetAddChar(set.get(), character);
    const Pattern pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcPatternAddCharSet(pattern.get(), FC_CHARSET, set.get());
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
    FcConfigSubstitute(config, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    return FontSet(FcFontSort(config, pattern.get(), FcTrue, nullptr, &result));
}

// Whether our rasteriser reads it.
bool has_outlines(FcPattern& font) {
    FcChar8* format = nullptr;
    FcBool coloured = FcFalse;
    FcPatternGetBool(&font, FC_COLOR, 0, &coloured);
    if (coloured == FcTrue || FcPatternGetString(&font, FC_FONTFORMAT, 0, &format) != FcResultMatch)
        return false;
    const std::string_view name(reinterpret_cast<const char*>(format));
    return name == "TrueType" || name == "CFF";
}

bool has_any(FcPattern& font, const std::vector<ImWchar>& characters) {
    FcCharSet* set = nullptr;
    if (FcPatternGetCharSet(&font, FC_CHARSET, 0, &set) != FcResultMatch) return false;
    return std::any_of(characters.begin(), characters.end(),
                       [&](ImWchar character) { return FcCharSetHasChar(set, character) == FcTrue; });
}

std::vector<unsigned char> bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

FallbackFonts::FallbackFonts() = default;
FallbackFonts::~FallbackFonts() = default;

void FallbackFonts::Unload::operator()(_FcConfig* config) const { FcConfigDestroy(config); }

bool FallbackFonts::find(const std::vector<ImWchar>& characters) {
    std::vector<ImWchar> left;
    for (const ImWchar character : characters)
        if (asked_.insert(character).second) left.push_back(character);
    const std::size_t asked = left.size();
    if (asked == 0) return false;
    take_from_inter(left);
    if (!left.empty() && !config_) config_.reset(FcInitLoadConfigAndFonts());
    if (!left.empty() && config_)
        if (const FontSet fonts = sorted_fonts(config_.get(), left))
            for (int i = 0; i < fonts->nfont && !left.empty(); ++i) take_from(*fonts->fonts[i], left);
    return left.size() < asked;
}

// What it has beyond the usual ranges.
void FallbackFonts::take_from_inter(std::vector<ImWchar>& characters) {
    if (!ui::font_regular().empty()) take(ui::font_regular(), 0, characters);
}

void FallbackFonts::take_from(FcPattern& font, std::vector<ImWchar>& characters) {
    FcChar8* name = nullptr;
    int index = 0;
    if (!has_outlines(font) || !has_any(font, characters) ||
        FcPatternGetString(&font, FC_FILE, 0, &name) != FcResultMatch ||
        FcPatternGetInteger(&font, FC_INDEX, 0, &index) != FcResultMatch)
        return;
    const std::filesystem::path path(reinterpret_cast<const char*>(name));
    const int face = index & face_bits;
    const auto known = std::find_if(files_.begin(), files_.end(), [&](const FontFile& file) {
        return file.path == path && file.face == face;
    });
    if (known != files_.end()) {
        take(known->bytes, face, characters);
        return;
    }
    files_.push_back({path, face, bytes_of(path)});
    if (!take(files_.back().bytes, face, characters)) files_.pop_back();
}

// Returns whether the font drew any of them.
bool FallbackFonts::take(std::span<const unsigned char> bytes, int face, std::vector<ImWchar>& characters) {
    constexpr std::size_t least = 12;  // of a table of contents
    stbtt_fontinfo font{};
    const int offset = bytes.size() < least ? -1 : stbtt_GetFontOffsetForIndex(bytes.data(), face);
    if (offset < 0 || stbtt_InitFont(&font, bytes.data(), offset) == 0) return false;
    const auto without = std::stable_partition(characters.begin(), characters.end(), [&](ImWchar character) {
        return stbtt_FindGlyphIndex(&font, character) == 0;
    });
    if (without == characters.end()) return false;
    ui::ExtraFont extra{.bytes = bytes, .face = face, .ranges = {}};
    for (auto it = without; it != characters.end(); ++it) extra.ranges.insert(extra.ranges.end(), 2, *it);
    extra.ranges.push_back(0);
    fonts_.push_back(std::move(extra));
    characters.erase(without, characters.end());
    return true;
}

}  // namespace nacre
