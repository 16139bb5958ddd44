// The whole window against its reference pictures.
#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/headless/screenshot.h"
#include "core/design/design_file.h"
#include "tests/gl/golden.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// The references were made with this Dear ImGui: another one draws letters elsewhere.
constexpr bool other_imgui = IMGUI_VERSION_NUM != 18600;

// Rounding and another llvmpipe move a value by one or two; a letter that is another one changes some 20
// pixels by tens.
constexpr GoldenRule rule{.noticed = 8, .pixels = 10};

struct State {
    const char* name;
    const char* preset;  // empty: a new design
    const char* script;
};

constexpr State states[] = {
    {"window-start", "", ""},
    {"window-painted", "copper",
     "click \"Paint\"\nclick \"Symmetry\"\nclick \"Symmetry Turns\"\ndrag \"Canvas\":@38,10 "
     "\"Canvas\":@62,55 16\n"
     "move \"Canvas\":@50,100\nwait\nframes 2\n"},
    {"window-plots", "brushed-gold",
     "click \"Plots\"\nclick \"Plot lobe3d\"\nwait\nmove \"Plot\":0.3,0.5\nframes 2\n"}};

constexpr glm::ivec2 size{1280, 800};

// Of a pixel's first value.
std::ptrdiff_t place(float x, float y) {
    return (std::ptrdiff_t{static_cast<int>(y)} * size.x + static_cast<int>(x)) * 3;
}

// Three values a pixel. The status line is black from the sentence on that tells the time of the bake.
std::vector<float> picture_of(const State& state) {
    ScreenshotOptions options;
    if (*state.preset)
        options.document =
            Document(load_design(std::string(NACRE_SOURCE_DIR "/presets/") + state.preset + ".nacre"));
    options.script = parse_events(state.script, state.name);
    HeadlessDesigner stage({.size = options.size, .bake_threads = 2});
    const Screenshot shot = screenshot(options, stage);
    const auto tables = stage.items().rectangle("Baked tables"), plots = stage.items().rectangle("Plots");
    REQUIRE((tables && plots));
    std::vector<float> rgb;
    for (std::size_t i = 0; i < shot.rgba.size(); ++i)
        if (i % 4 < 3) rgb.push_back(static_cast<float>(shot.rgba[i]) / 255);
    for (float row = tables->y; row < tables->w + 2; ++row)  // letters reach below their box
        std::fill(rgb.begin() + place(tables->x, row), rgb.begin() + place(plots->x - 1, row), 0.0f);
    return rgb;
}

}  // namespace

TEST_SUITE_BEGIN("golden");

TEST_CASE("every state of the window looks as it did" * doctest::skip(other_imgui)) {
    for (const State& state : states) check_golden(state.name, rule, size, picture_of(state));
}

TEST_CASE("a letter that is missing in the window would be noticed") {
    const std::vector<float> window = picture_of(states[0]);
    CHECK(golden_fault(rule, window, window) == "");
    HeadlessDesigner stage({.size = size, .bake_threads = 2});
    screenshot({}, stage);
    const auto word = stage.items().rectangle("Layers");
    REQUIRE(word);
    // What stands above the letter in its place.
    const float left = (word->x + word->z) / 2 - 4;
    std::vector<float> without = window;
    for (float row = word->y; row < word->w; ++row)
        std::copy_n(window.begin() + place(left, word->y), 3 * 8, without.begin() + place(left, row));
    CHECK(golden_fault(rule, without, window) != "");
}

TEST_SUITE_END();
