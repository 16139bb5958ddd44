// Fonts of this machine for the characters that the embedded one lacks: file names come in any script.
#pragma once

#include <imgui.h>

#include <deque>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "ui/theme.h"

struct _FcConfig;
struct _FcPattern;

namespace nacre {

class FallbackFonts {
  public:
    FallbackFonts();
    ~FallbackFonts();

    // Looks for fonts with these characters, each once. Returns whether something was found.
    bool find(const std::vector<ImWchar>& characters);

    // What was found; valid until the next find().
    const std::vector<ui::ExtraFont>& fonts() const { return fonts_; }

  private:
    struct FontFile {
        std::filesystem::path path;
        int face = 0;  // of those in the file
        std::vector<unsigned char> bytes;
    };
    struct Unload {
        void operator()(_FcConfig* config) const;
    };

    void take_from_inter(std::vector<ImWchar>& characters);
    void take_from(_FcPattern& font, std::vector<ImWchar>& characters);
    bool take(std::span<const unsigned char> bytes, int face, std::vector<ImWchar>& characters);

    std::unique_ptr<_FcConfig, Unload> config_;  // with the first character
    std::set<ImWchar> asked_;
    std::deque<FontFile> files_;  // their bytes stay where they are
    std::vector<ui::ExtraFont> fonts_;
};

}  // namespace nacre
