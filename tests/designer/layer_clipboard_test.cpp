// Layers on the clipboard: cut, copied and pasted within a design and into another window's.
#include "app/designer/layer_clipboard.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/image/image_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::Rig;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;

namespace {

std::string clipboard() {
    const char* text = ImGui::GetClipboardText();
    return text != nullptr ? text : "";
}

std::shared_ptr<const Raster> raster_of(int side) {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = side;
    for (int i = 0; i < side * side; ++i) raster->values.push_back(0.1f + static_cast<float>(i % 7) / 9);
    return raster;
}

Layer tilted(const std::string& name) {
    Layer layer;
    layer.name = name;
    layer.lobe = GgxLobe{0.1, 0.3};
    layer.weight = 0.25;
    layer.tilt = 20;
    layer.tint = {1, 0.5, 0.25};
    return layer;
}

std::string refusal(const std::string& text, std::size_t room = 15) {
    try {
        layers_of_text(text, room);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("clipboard: a layer goes to another window as it is, after the chosen one, in one step of undo") {
    std::string text;
    const Layer layer = tilted("Sheen");
    {
        Rig r;
        r.layers()[0] = layer;
        r.play("frames 2\nkey Ctrl+C\nframes 2");
        text = clipboard();
        CHECK(r.designer().files.message() == "Copied Sheen");
        CHECK(r.layers().size() == 1);
    }
    CHECK(parse_design(text, "text", "/").distribution.layers == std::vector{layer});
    Rig r;
    r.play("click \"Duplicate layer\"\nframes 2\nkey 1\nframes 2");
    const Design before = r.document().design;
    ImGui::SetClipboardText(text.c_str());
    r.play("key Ctrl+V\nframes 2");
    REQUIRE(r.layers().size() == 3);
    CHECK(r.layers()[1] == layer);
    CHECK(r.designer().layers.chosen == 1);
    CHECK(r.designer().files.message() == "Pasted Sheen");
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.document().design == before);
    r.play("key Ctrl+Y\nframes 2");
    CHECK(r.layers().size() == 3);
}

TEST_CASE("clipboard: a cut layer is gone in one step of undo, and the last one stays") {
    Rig r;
    r.layers().push_back(tilted("Sheen"));
    r.play("frames 2\nkey 2\nkey Ctrl+X\nframes 2");
    CHECK(r.layers().size() == 1);
    CHECK(clipboard().find("Sheen") != std::string::npos);
    r.play("key Ctrl+Z\nframes 2");
    REQUIRE(r.layers().size() == 2);
    CHECK(r.layers()[1] == tilted("Sheen"));
    r.play("key Ctrl+Y\nframes 2");
    ImGui::SetClipboardText("before");
    r.play("key Ctrl+X\nframes 2");
    CHECK(r.layers().size() == 1);
    CHECK(clipboard() == "before");
    CHECK(r.designer().files.message() == "A design needs at least one layer: copy it instead");
}

TEST_CASE("clipboard: menus do it too, and Ctrl+D copies without the clipboard") {
    Rig r;
    r.layers()[0] = tilted("Sheen");
    r.play("frames 2\nclick \"Layer 1\" right\nframes 3\nclick \"Menu Copy\"\nframes 3");
    CHECK(clipboard().find("Sheen") != std::string::npos);
    r.play("click \"Layer 1\" right\nframes 3\nclick \"Menu Paste\"\nframes 3");
    CHECK(r.layers().size() == 2);
    r.play("click \"Layer 2\" right\nframes 3\nclick \"Menu Cut\"\nframes 3");
    CHECK(r.layers().size() == 1);
    r.play("click \"Edit\"\nframes 3\nclick \"Paste\"\nframes 3");
    CHECK(r.layers().size() == 2);
    ImGui::SetClipboardText("before");
    r.play("key Ctrl+D\nframes 2");
    CHECK(r.layers().size() == 3);
    CHECK(r.designer().layers.chosen == 2);
    CHECK(clipboard() == "before");
}

TEST_CASE("clipboard: a field that is typed in keeps the keys") {
    Rig r;
    r.layers()[0].name = "Sheen";
    r.play("frames 2\nclick \"Layer name\"\nframes 3\nkey Ctrl+A\nkey Ctrl+X\nframes 3");
    CHECK(clipboard() == "Sheen");
    CHECK(r.layers().size() == 1);
    r.play("key Ctrl+V\nkey Ctrl+V\nframes 3");
    CHECK(r.layers().size() == 1);
    CHECK(r.layers()[0].name == "SheenSheen");
}

TEST_CASE("clipboard: foreign text is refused in one line and changes nothing") {
    Rig r;
    const Design before = r.document().design;
    for (const char* text : {"", "hello", "{\"colour\": 3}", "[1, 2]", "\"nacre\"", "\xff\xfe{"}) {
        CAPTURE(text);
        r.designer().files.tell("");
        ImGui::SetClipboardText(text);
        r.play("key Ctrl+V\nframes 2");
        CHECK(r.designer().files.message() == "The clipboard holds no layers of Nacre.");
    }
    for (const char* text :
         {"{\"nacre\": 99}", "{\"nacre\": 1, \"distribution\": {\"layers\": []}}", "{\"nacre\""}) {
        CAPTURE(text);
        ImGui::SetClipboardText(text);
        r.play("key Ctrl+V\nframes 2");
        CHECK(r.designer().files.message().starts_with("Cannot paste: the clipboard"));
        CHECK(r.designer().files.message().find('\n') == std::string::npos);
    }
    CHECK(r.document().design == before);
    CHECK(!r.document().unsaved());
}

TEST_CASE("clipboard: a design holds no more layers than it may, whatever is pasted") {
    Rig r;
    Design many;
    many.distribution.layers.assign(3, tilted("a"));
    const std::string text = portable_design_json(many);
    CHECK(layers_of_text(text, 3).size() == 3);
    CHECK(refusal(text, 2).find("no more than 16") != std::string::npos);
    r.layers().assign(limits::layers_max, tilted("b"));
    r.play("frames 2\nkey Ctrl+C\nkey Ctrl+V\nkey Ctrl+D\nframes 2");
    CHECK(r.layers().size() == limits::layers_max);
    CHECK(r.designer().files.message().find("no more than 16") != std::string::npos);
}

TEST_CASE("clipboard: pictures in the design go with the text, files by their absolute path") {
    const TemporaryFolder folder;
    Layer layer = tilted("Painted");
    layer.modulation = Modulation{{{}, raster_of(8), {}}, 0.5};
    CHECK(layers_of_text(layer_text(layer), 1) == std::vector{layer});
    write_image(folder / "a.png", {4, 4}, std::vector<float>(48, 0.5f));
    Design design;
    design.distribution.layers = {layer};
    design.distribution.layers[0].modulation->image.file = folder / "a.png";
    const std::string text = layer_text(design.distribution.layers[0]);
    CHECK(text.find('"' + (folder / "a.png").string() + '"') != std::string::npos);
    const Layer back = layers_of_text(text, 1).front();
    REQUIRE(back.modulation);
    CHECK(back.modulation->image.file == folder / "a.png");
    CHECK(back.modulation->image.raster->width == 4);
    std::filesystem::remove(folder / "a.png");
    CHECK(refusal(text).find("a.png") != std::string::npos);
}

TEST_CASE("clipboard: what is too large for it is told, and the old text stays") {
    Rig r;
    Layer& layer = r.layers()[0];
    layer.modulation = Modulation{{{}, raster_of(1024), {}}, 1};
    layer.lobe = PaintedLobe{.image = {{}, raster_of(1024), {}}};
    ImGui::SetClipboardText("before");
    r.play("frames 2\nkey Ctrl+C\nframes 2");
    CHECK(clipboard() == "before");
    CHECK(r.designer().files.message().find("larger than the 15 MB") != std::string::npos);
    r.layers().push_back(r.layers()[0]);
    r.play("frames 2\nkey Ctrl+X\nframes 2");
    CHECK(r.layers().size() == 2);
}
