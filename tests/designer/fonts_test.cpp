// Text in any script: what the embedded font lacks comes from the machine's, and else is a box.
#include <doctest/doctest.h>
#include <imgui.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "app/designer/fallback_fonts.h"
#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"
#include "ui/missing_glyphs.h"

using namespace nacre;
using nacre::test::Rig;
using nacre::test::TemporaryFolder;

namespace {

// fontconfig knows the fonts of one folder alone.
class OnlyFonts {
  public:
    OnlyFonts(const TemporaryFolder& folder, const std::string& fonts) {
        std::ofstream(folder / "fonts.conf")
            << "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>" << fonts
            << "</dir><cachedir>" << (folder / "cache").string() << "</cachedir></fontconfig>";
        setenv("FONTCONFIG_FILE", (folder / "fonts.conf").c_str(), 1);
    }
    ~OnlyFonts() { unsetenv("FONTCONFIG_FILE"); }
};

constexpr const char* chinese_fonts = "/usr/share/fonts/truetype/droid";

std::vector<ImWchar> missing() { return ui::missing_characters(*ImGui::GetDrawData()); }

// Width of a character in the interface's font.
float advance(ImWchar character) { return ImGui::GetIO().Fonts->Fonts[0]->FindGlyph(character)->AdvanceX; }

bool is_a_box(ImWchar character) {
    const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
    const ImFontGlyph& box = *font.FindGlyph(0xE9);  // a letter of Inter
    const ImFontGlyph& glyph = *font.FindGlyph(character);
    const ImFontAtlasCustomRect& tile = ImGui::GetIO().Fonts->CustomRects[0];
    const float texels = (glyph.U0 * static_cast<float>(ImGui::GetIO().Fonts->TexWidth));
    return &glyph != &box && texels >= tile.X && texels < static_cast<float>(tile.X) + 0.2f && glyph.Visible;
}

}  // namespace

TEST_CASE("fonts: a name in another script is drawn with a font of the machine, from the next frame on") {
    const TemporaryFolder folder;
    const OnlyFonts fonts(folder, chinese_fonts);
    Rig r;
    CHECK(is_a_box(0x6F06));
    r.layers()[0].name =
        "\u6f06\u91cd \u0141ak \u0391\u03b8 \u041b\u0430\u043a";  // Chinese, Polish, Greek, Russian
    r.play("frames 1");
    CHECK(missing() == std::vector<ImWchar>{0x6F06, 0x91CD});
    r.play("frames 2");
    CHECK(missing().empty());
    CHECK(!is_a_box(0x6F06));
    CHECK(ImGui::GetIO().Fonts->Fonts[1]->FindGlyph(0x6F06)->Visible);
    CHECK(advance(0x6F06) > 10);
    // Another monitor's scale keeps them.
    r.stage.set_scale(2);
    r.play("frames 2");
    CHECK(!is_a_box(0x6F06));
    CHECK(missing().empty());
}

TEST_CASE("fonts: where no font has a character a box stands, and the search is not made again") {
    const TemporaryFolder folder;
    const OnlyFonts none(folder, (folder / "none").string());
    Rig r;
    r.layers()[0].name = "\u6f06\ue000\u0e01";
    r.play("frames 3");
    CHECK(missing() == std::vector<ImWchar>{0x0E01, 0x6F06, 0xFFFD});  // the private one is nobody's
    CHECK(is_a_box(0x6F06));
    CHECK(is_a_box(0xFFFD));
    const auto* built = ImGui::GetIO().Fonts->TexPixelsAlpha8;
    r.play("frames 3");
    CHECK(ImGui::GetIO().Fonts->TexPixelsAlpha8 == built);
}

TEST_CASE("fonts: what Inter has beyond Europe's alphabets is Inter's, and joiners take no room") {
    const TemporaryFolder folder;
    const OnlyFonts none(folder, (folder / "none").string());
    Rig r;
    r.layers()[0].name = "e\u0301 \u2b06 a\u200bb";
    r.play("frames 3");
    CHECK(missing().empty());
    CHECK(!is_a_box(0x0301));
    CHECK(advance(0x200B) == 0);
}

TEST_CASE("fonts: the interface itself needs no font of the machine") {
    Rig r;
    for (const char* tab : {"Layers", "Material", "Light", "Compare", "Presets"}) {
        CAPTURE(tab);
        r.play("click \"" + std::string(tab) + "\"\nframes 1");
        CHECK(missing().empty());
    }
    r.play("click \"Plots\"\nframes 3\nkey F1\nframes 3");
    CHECK(missing().empty());
}

TEST_CASE("fonts: a file whose name is no UTF-8 opens, shows replacements and is saved in its place") {
    const TemporaryFolder folder;
    Design design = starter_design();
    design.name.clear();
    const std::filesystem::path file = folder / "s\xe9mi\xff.nacre";
    save_design(design, file);
    Rig r;
    take_file(r.designer(), file);
    r.play("frames 3");
    CHECK(r.document().file == file);
    CHECK(r.document().design == design);
    r.play("frames 30\ndrag \"Width x\":0.3 \"Width x\":0.8\nkey Ctrl+S\nframes 3");
    CHECK(!r.designer().files.talking());
    CHECK(load_design(file) == r.document().design);
    CHECK(!r.document().unsaved());
}
