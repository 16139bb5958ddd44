// A painter who tries everything, in no order.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "app/headless/stage.h"
#include "core/design/design_file.h"

using namespace nacre;

namespace {

// One random action as lines of a script.
class Painter {
  public:
    explicit Painter(unsigned seed) : random_(seed) {}

    std::string act() {
        static const std::vector<std::string> tools = {"Handles", "Grab",  "Paint", "Erase", "Smooth",
                                                       "Smear",   "Stamp", "Line",  "Ring",  "Star"};
        switch (pick(10)) {
            case 0:
                return "click \"" + tools[pick(tools.size())] + "\"\n";
            case 1:
                return "key Ctrl+Z\n";
            case 2:
                return "key Ctrl+Y\n";
            case 3:
                return pick(2) ? "key [\n" : "key ]\n";
            case 4:
                return pick(4) ? "move " + normal() + "\nwheel " + std::to_string(int(pick(9)) - 4) + "\n"
                               : "click \"Dome\"\n";
            case 5:
                return "drag \"Preview\":" + fraction() + "," + fraction() + " \"Preview\":" + fraction() +
                       "," + fraction() + " 3\n";
            case 6:
                return pick(3) ? "click \"Straighten\"\n" : "click \"New painted layer\"\n";
            default:
                return "drag " + normal() + " " + normal() + " " + std::to_string(1 + pick(4)) + "\n";
        }
    }

  private:
    std::size_t pick(std::size_t count) { return random_() % count; }
    std::string fraction() { return "0." + std::to_string(2 + pick(6)); }
    std::string normal() {
        return "\"Canvas\":@" + std::to_string(pick(95)) + "," + std::to_string(pick(360));
    }
    std::mt19937 random_;
};

}  // namespace

TEST_CASE("painter: a hundred random actions leave a design that its file holds, and all can be undone") {
    Stage stage({.size = {1280, 800}, .ui_scale = 1, .bake_threads = 1});
    stage.frame();
    stage.frame();
    Document& document = stage.designer().document;
    const Design before = document.design;
    Painter painter(20260);
    for (int i = 0; i < 100; ++i) {
        const std::string action = painter.act();
        CAPTURE(action);
        // A button of another tool is not on the screen.
        if (action.find("Straighten") != std::string::npos && !stage.items().rectangle("Straighten"))
            continue;
        stage.play(parse_events(action, "painter"));
        for (const Layer& layer : document.design.distribution.layers) {
            REQUIRE(std::isfinite(layer.weight));
            REQUIRE(layer.weight >= 0);
            REQUIRE(layer.weight <= limits::weight_max);
            REQUIRE(layer.tilt <= limits::tilt_max);
        }
    }
    document.commit();
    const Design painted = document.design;
    CHECK(painted != before);
    REQUIRE(document.history.can_undo());
    CHECK(parse_design(design_json(painted, "."), "test", ".") == painted);
    while (document.history.can_undo()) document.undo();
    CHECK(document.design == before);
    for (int i = 0; i < 100; ++i) document.redo();
    CHECK(!document.history.can_redo());
}
