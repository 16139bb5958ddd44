// nacre-crash-child paint|save|export FOLDER: works in the folder until it is killed, and tells on standard
// output what it has done, a line each. nacre-test-crash kills it. Beside these, what shortage.h does.
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/designer/autosave.h"
#include "app/designer/file_flow.h"
#include "app/headless/stage.h"
#include "core/paint/painted_layer.h"
#include "tests/crash/child/shortage.h"
#include "tests/crash/exports.h"
#include "tests/crash/numbered_design.h"

namespace {

namespace fs = std::filesystem;
using nacre::test::stroke_name;

constexpr std::chrono::microseconds frame_time(16'667);

// In one write, so that a line is whole or not there.
void tell(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) std::exit(1);
}

std::string told(int stroke, const nacre::Design& design) {
    return std::to_string(stroke) + " " + std::to_string(nacre::test::digest(design));
}

// At the pace of a window: sixty frames a second.
class Hand {
  public:
    explicit Hand(nacre::HeadlessDesigner& stage) : stage_(stage) {}
    void play(const std::string& events) { stage_.play(nacre::parse_events(events, "crash")); }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            next_ = std::max(next_ + frame_time, std::chrono::steady_clock::now());
            std::this_thread::sleep_until(next_);
            stage_.frame(false);
        }
    }

  private:
    nacre::HeadlessDesigner& stage_;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
};

std::string canvas_place(int stroke, int step) {
    const double theta = 10 + 60 * std::fabs(std::sin(stroke * 0.7 + step * 0.05));
    return "\"Canvas\":@" + std::to_string(theta) + "," + std::to_string((stroke * 67 + step * 9) % 360);
}

// Strokes with the brush on the canvas, one after another as a hand makes them: none ends before the one
// before it is kept.
void paint(const fs::path& folder) {
    nacre::HeadlessDesigner stage({.size = {640, 400}, .bake_threads = 1, .folders = {.state = folder}});
    Hand hand(stage);
    hand.frames(2);
    hand.play("click \"Paint\"");
    tell("ready");
    nacre::Designer& designer = stage.designer();
    for (int stroke = 1;; ++stroke) {
        hand.play("move " + canvas_place(stroke, 0) + "\ndown left");
        for (int step = 1; step <= 5; ++step) {
            hand.play("move " + canvas_place(stroke, step));
            hand.frames(1);
        }
        while (designer.autosave.busy()) hand.frames(1);
        designer.document.design.name = stroke_name(stroke);
        hand.play("up left");
        hand.frames(1);
        tell(told(stroke, designer.document.history.current()));
    }
}

// Changes and saves, as fast as they go.
void save(const fs::path& folder) {
    nacre::Settings settings;
    nacre::RecentFiles recent(folder / "state");
    nacre::FileFlow files;
    files.remember({.settings = &settings, .recent = &recent, .dialogs = {}, .home = folder, .inputs = {}});
    nacre::Autosave autosave(folder / "unsaved");
    nacre::Document document(nacre::starter_design(), folder / "work.nacre");
    document.held = nacre::held_now(std::array<fs::path, 1>{document.file});
    nacre::Layer layer = nacre::blank_painted_layer();
    auto raster = std::make_shared<nacre::Raster>(*std::get<nacre::PaintedLobe>(layer.lobe).image.raster);
    for (int stroke = 1;; ++stroke) {
        for (std::size_t i = 0; i < raster->values.size(); ++i)
            raster->values[i] = static_cast<float>(std::fabs(std::sin(0.37 * double(i) + stroke)));
        const double mass = nacre::raster_mass(*std::get<nacre::PaintedLobe>(layer.lobe).image.raster);
        nacre::set_raster(layer, std::make_shared<nacre::Raster>(*raster), mass, 1);
        document.design.distribution.layers.resize(1);
        document.design.distribution.layers.push_back(layer);
        document.design.name = stroke_name(stroke);
        document.commit();
        autosave.follow(document);
        tell("began " + told(stroke, document.design));
        files.save(document);
        if (files.talking()) std::exit(1);
        tell("saved " + std::to_string(stroke));
        autosave.follow(document);
        if (stroke == 1) tell("ready");
    }
}

void export_over_and_over(const fs::path& folder) {
    const nacre::test::Exports exports;
    for (int turn = 0;; ++turn) {
        exports.write(turn % 2, folder);
        if (turn == 0) tell("ready");
    }
}

}  // namespace

int main(int count, char** values) {
    const std::string mode = count == 3 ? values[1] : "";
    try {
        if (mode == "paint") paint(values[2]);
        if (mode == "save") save(values[2]);
        if (mode == "export") export_over_and_over(values[2]);
        if (mode == "without-pictures") return nacre::test::without_pictures(values[2]), 0;
        if (mode == "without-memory") return nacre::test::without_memory(values[2]), 0;
        std::fprintf(stderr, "nacre-crash-child paint|save|export FOLDER\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nacre-crash-child: %s\n", error.what());
    }
    return 1;
}
