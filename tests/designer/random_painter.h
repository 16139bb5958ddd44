// A painter who tries everything, in no order.
#pragma once

#include <array>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace nacre::test {

// Random actions, each as lines of an event script (docs/event-scripts.md). Not every widget that they name
// is on the screen at every time.
class RandomPainter {
  public:
    // `pictures` are files to drop.
    RandomPainter(unsigned seed, std::vector<std::filesystem::path> pictures)
        : random_(seed), pictures_(std::move(pictures)) {}

    std::vector<std::string> act() {
        switch (pick(16)) {
            case 0:
            case 1:
                return {click(one_of(tools))};
            case 2:
                return {"key Ctrl+Z"};
            case 3:
                return {"key Ctrl+Y"};
            case 4:
                return brush();
            case 5:
                return view();
            case 6:
                return {drag(on_preview(), on_preview())};
            case 7:
                return {click(one_of(balances))};
            case 8:
            case 9:
                return layers();
            case 10:
                return picture();
            case 11:
                return {"key " + std::string(one_of(selecting))};
            case 12:
                return {click("Paint the mask")};
            default:
                return {drag(normal(), normal())};
        }
    }

  private:
    std::vector<std::string> brush() {
        switch (pick(4)) {
            case 0:
                return {click("Symmetry"), "frames 2", click("Symmetry " + std::string(one_of(symmetries)))};
            case 1:
                return {drag("\"Hardness\":" + fraction(), "\"Hardness\":" + fraction())};
            case 2:
                return {drag("\"Flow\":" + fraction(), "\"Flow\":" + fraction())};
            default:
                return {pick(2) ? "key [" : "key ]"};
        }
    }

    std::vector<std::string> view() {
        if (pick(4) == 0) return {click(pick(2) ? "Dome" : "Scale")};
        return {"move " + normal(), "wheel " + std::to_string(static_cast<int>(pick(9)) - 4)};
    }

    std::vector<std::string> layers() {
        const std::string layer = "Layer " + std::to_string(1 + pick(4));
        switch (pick(10)) {
            case 0:
                return {click("Add layer"), "frames 2", click("Add " + std::string(one_of(lobes)))};
            case 1:
                return {click(one_of(layer_buttons))};
            case 2:
            case 3:
            case 4:
            case 5:
                return {click("Delete layer")};
            case 6:
                return {click(layer + " enabled")};
            case 7:
                return {click(layer + " solo")};
            case 8:
                return {drag("\"Weight\":" + fraction(), "\"Weight\":" + fraction())};
            default:
                return {click(layer)};
        }
    }

    std::vector<std::string> picture() {
        const std::string file = pictures_[pick(pictures_.size())].string();
        return {"drop \"" + file + "\"", "frames 3", click(one_of(answers)),
                click(pick(4) > 0 ? "Import" : "Cancel"), "frames 2"};
    }

    std::string click(const std::string& name) const { return "click \"" + name + "\""; }
    std::string drag(const std::string& from, const std::string& to) {
        return "drag " + from + " " + to + " " + std::to_string(1 + pick(4));
    }
    std::string fraction() { return "0." + std::to_string(2 + pick(6)); }
    std::string on_preview() { return "\"Preview\":" + fraction() + "," + fraction(); }
    std::string normal() {
        return "\"Canvas\":@" + std::to_string(pick(95)) + "," + std::to_string(pick(360));
    }

    std::size_t pick(std::size_t count) { return random_() % count; }
    template <std::size_t count>
    const char* one_of(const std::array<const char*, count>& names) {
        return names[pick(count)];
    }

    static constexpr std::array tools = {
        "Handles",      "Grab",     "Paint", "Erase", "Smooth", "Smear",    "Stamp",
        "Line",         "Ring",     "Star",  "Fill",  "Fill",   "Gradient", "Select rectangle",
        "Select lasso", "Transform"};
    static constexpr std::array selecting = {"Ctrl+A",       "Ctrl+Shift+A", "Ctrl+Shift+A",
                                             "Ctrl+Shift+I", "Delete",       "Shift+Backspace"};
    static constexpr std::array symmetries = {"No symmetry", "Mirror x", "Mirror y",
                                              "Mirror both", "Turns",    "Full ring"};
    static constexpr std::array balances = {"Balance", "Balance", "Straighten", "New painted layer"};
    static constexpr std::array lobes = {"Gaussian", "GGX", "Beckmann", "Uniform", "Curve", "Painted"};
    static constexpr std::array layer_buttons = {"Duplicate layer", "Layer up", "Layer down"};
    static constexpr std::array answers = {"As Stamp", "As Normals", "As Heights", "As Modulation"};

    std::mt19937 random_;
    std::vector<std::filesystem::path> pictures_;
};

}  // namespace nacre::test
