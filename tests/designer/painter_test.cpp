// Sixty random actions in every test; NACRE_PAINTER_ACTIONS=2000 makes a painter's hour of it
// (scripts/painters-hour runs that under the sanitizers).
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/image/image_file.h"
#include "tests/core/random_directions.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/random_painter.h"
#include "tests/designer/rig.h"

#ifdef NACRE_SANITIZED
// Of the sanitizers' runtime (its sanitizer/allocator_interface.h, which g++ does not install).
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

using namespace nacre;

namespace {

constexpr int usual_actions = 60;
constexpr unsigned seed = 20260;

int actions_wanted() {
    const char* wanted = std::getenv("NACRE_PAINTER_ACTIONS");
    return wanted ? std::max(std::atoi(wanted), usual_actions) : usual_actions;
}

// How often everything is checked.
int checks_of(int actions) { return std::clamp(actions / 50, 2, 20); }

// What is in use, MiB. Under a sanitizer what was asked for and not given back: its shadow of each address
// that was ever used stays resident.
#ifdef NACRE_SANITIZED
constexpr bool counted_exactly = true;
double used_mebibytes() { return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / (1 << 20); }
#else
constexpr bool counted_exactly = false;
double used_mebibytes() {
    std::ifstream statm("/proc/self/statm");
    double pages = 0, resident = 0;
    statm >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}
#endif

std::filesystem::path noise_picture(const test::TemporaryFolder& folder, const char* name,
                                    glm::dvec3 middle) {
    constexpr int side = 48;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<float> rgb;
    for (int i = 0; i < side * side; ++i)
        for (int c = 0; c < 3; ++c)
            rgb.push_back(static_cast<float>(std::clamp(middle[c] + 0.1 * normal(random), 0.0, 1.0)));
    write_image(folder / name, {side, side}, rgb);
    return folder / name;
}

class Hour {
  public:
    Hour()
        : painter_(seed, {noise_picture(folder_, "normals.png", {0.5, 0.5, 0.9}),
                          noise_picture(folder_, "heights.png", glm::dvec3(0.5))}) {}

    // Up to the first line whose widget is not on the screen.
    void act() {
        const std::vector<std::string> lines = painter_.act();
        for (const std::string& line : lines) {
            CAPTURE(line);
            rig_.play("frames 1");
            if (!on_screen(line)) break;
            rig_.play(line);
        }
        rig_.designer().pictures.wait();
        rig_.play("frames 2");
        // A question about a dropped picture, or why it was not taken.
        for (const char* answer : {"Cancel", "OK"}) {
            if (!rig_.designer().pictures.talking()) break;
            rig_.play("frames 2");
            const std::string line = "click \"" + std::string(answer) + "\"";
            if (on_screen(line)) rig_.play(line);
        }
        rig_.play("key Escape");
        REQUIRE(!rig_.designer().pictures.talking());
        REQUIRE(!rig_.designer().files.talking());
        check_numbers();
    }

    void check_all() {
        rig_.document().commit();
        check_live();
        check_picture();
        check_undo(5);
        const Design& design = rig_.document().design;
        CHECK(parse_work(design_json(design, "."), "test", ".") == design);
    }

    // As a user begins anew, whatever was there.
    void begin_anew() {
        rig_.play("key Ctrl+N\nframes 2");
        if (on_screen("click \"Discard\"")) rig_.play("click \"Discard\"");
        rig_.play("wait\nframes 2");
        REQUIRE(!rig_.document().history.can_undo());
    }

    // So many steps back and forth, or all there are; returns what was before them.
    Design check_undo(std::size_t most) {
        Document& document = rig_.document();
        std::vector<Design> before = {document.design};
        while (document.history.can_undo() && before.size() <= most) {
            document.undo();
            before.push_back(document.design);
            rig_.play("frames 1");
        }
        for (std::size_t i = before.size() - 1; i-- > 0;) {
            document.redo();
            REQUIRE(document.design == before[i]);
        }
        rig_.play("frames 2");
        return before.back();
    }

    test::Rig& rig() { return rig_; }

  private:
    bool on_screen(const std::string& line) const {
        if (line.starts_with("drop")) return true;
        for (std::size_t begin = line.find('"'); begin != std::string::npos;) {
            const std::size_t end = line.find('"', begin + 1);
            if (!rig_.stage.items().rectangle(line.substr(begin + 1, end - begin - 1))) return false;
            begin = line.find('"', end + 1);
        }
        return true;
    }

    void check_numbers() {
        for (const Layer& layer : rig_.layers()) {
            REQUIRE(std::isfinite(layer.weight));
            REQUIRE(layer.weight >= 0);
            REQUIRE(layer.weight <= limits::weight_max);
            REQUIRE(layer.tilt <= limits::tilt_max);
            if (const auto* painted = std::get_if<PaintedLobe>(&layer.lobe))
                for (const float value : painted->image.raster->values) {
                    if (std::isfinite(value) && value >= 0) continue;
                    FAIL("a picture holds a value that is none");
                }
        }
    }

    // p that grew stroke by stroke against p made from the design.
    void check_live() {
        rig_.play("frames 1");
        const std::shared_ptr<const FacetDistribution> live = rig_.designer().frame.p;
        std::optional<FacetDistribution> fresh;
        try {
            fresh.emplace(ui::shown(rig_.designer().layers, rig_.document().design.distribution));
        } catch (const UserError&) {
        }
        REQUIRE((live != nullptr) == fresh.has_value());
        if (!live) return;
        CHECK(live->mean() == fresh->mean());
        Random random(4);
        for (int i = 0; i < 50; ++i) {
            const dvec3 k = test::random_direction(random);
            CHECK(live->density(k) == fresh->density(k));
            CHECK(live->projected_area(k) == fresh->projected_area(k));
        }
    }

    // What stands on the screen against what a canvas without a past draws.
    void check_picture() {
        const std::vector<std::uint8_t> shown = rested_picture();
        CanvasPane& canvas = rig_.designer().canvas;
        ui::CanvasState state = canvas.state;
        std::destroy_at(&canvas);
        std::construct_at(&canvas);
        canvas.state = std::move(state);
        const std::vector<std::uint8_t> anew = rested_picture();
        REQUIRE(shown.size() == anew.size());
        CHECK(std::equal(shown.begin(), shown.end(), anew.begin()));
    }

    // The canvas as it is once nothing moves, rows of pixels.
    std::vector<std::uint8_t> rested_picture() {
        rig_.play("move 2 2\nframes 20");
        rig_.stage.frame();
        const auto box = rig_.stage.items().rectangle("Canvas");
        REQUIRE(box);
        const std::vector<std::uint8_t> window = rig_.stage.pixels();
        std::vector<std::uint8_t> canvas;
        const auto width = static_cast<std::size_t>(rig_.stage.size().x);
        for (auto y = static_cast<std::size_t>(box->y); y < static_cast<std::size_t>(box->w); ++y)
            for (auto x = 4 * static_cast<std::size_t>(box->x); x < 4 * static_cast<std::size_t>(box->z); ++x)
                canvas.push_back(window[4 * y * width + x]);
        return canvas;
    }

    test::TemporaryFolder folder_;
    test::Rig rig_;
    test::RandomPainter painter_;
};

}  // namespace

TEST_CASE("painter: random actions leave a design that its file holds, can be undone, and leak nothing") {
    const int actions = actions_wanted(), checks = checks_of(actions);
    Hour hour;
    hour.begin_anew();
    const double at_first = used_mebibytes();
    Document& document = hour.rig().document();
    const Design before = document.design;
    std::vector<double> used;
    for (int check = 1; check <= checks; ++check) {
        const int begin = actions * (check - 1) / checks, end = actions * check / checks;
        for (int i = begin; i < end; ++i) {
            CAPTURE(i);
            hour.act();
        }
        hour.check_all();
        used.push_back(used_mebibytes());
        if (actions > usual_actions)
            MESSAGE("after " << end << " actions " << used.back() << " MiB, "
                             << document.design.distribution.layers.size() << " layers");
    }
    CHECK(document.design != before);
    const Design first = hour.check_undo(History::steps_max + 1);
    if (actions <= usual_actions) CHECK(first == before);
    // The history is full by the middle of an hour; what p holds comes and goes.
    if (actions >= 1000) CHECK(used.back() < 1.3 * used[used.size() / 2 - 1] + 64);
    hour.begin_anew();
    const double at_last = used_mebibytes();
    if (actions > usual_actions) MESSAGE("at first " << at_first << " MiB, anew " << at_last << " MiB");
    // The shader of each kind of surface that was shown stays compiled.
    if (counted_exactly) CHECK(at_last < at_first + 64);
}
