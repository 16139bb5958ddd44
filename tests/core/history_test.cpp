#include "core/design/history.h"

#include <doctest/doctest.h>

using namespace nacre;

namespace {

Design named(const std::string& name) {
    Design design;
    design.name = name;
    return design;
}

}  // namespace

TEST_SUITE("history") {
    TEST_CASE("history: undo and redo walk through the commits") {
        History history(named("a"), "start");
        CHECK_FALSE(history.can_undo());
        CHECK_FALSE(history.can_redo());
        history.commit(named("b"), "step");
        history.commit(named("c"), "step");
        history.undo();
        CHECK(history.current().name == "b");
        CHECK(history.can_undo());
        CHECK(history.can_redo());
        history.undo();
        history.undo();
        CHECK(history.current().name == "a");
        history.redo();
        history.redo();
        history.redo();
        CHECK(history.current().name == "c");
    }

    TEST_CASE("history: a commit drops what could be redone, an equal one does not") {
        History history(named("a"), "start");
        history.commit(named("b"), "step");
        history.undo();
        history.commit(named("a"), "step");
        CHECK(history.can_redo());
        history.commit(named("c"), "step");
        CHECK_FALSE(history.can_redo());
        history.undo();
        CHECK(history.current().name == "a");
        CHECK_FALSE(history.can_undo());
    }

    TEST_CASE("history: an equal picture behind another pointer is no new step") {
        const auto raster = [](float value) { return std::make_shared<const Raster>(Raster{1, 1, {value}}); };
        Design design;
        design.distribution.layers[0].lobe = PaintedLobe{{{}, raster(1)}};
        History history(design, "start");
        design.distribution.layers[0].lobe = PaintedLobe{{{}, raster(1)}};
        history.commit(design, "step");
        CHECK_FALSE(history.can_undo());
        design.distribution.layers[0].lobe = PaintedLobe{{{}, raster(2)}};
        history.commit(design, "step");
        CHECK(history.can_undo());
    }

    TEST_CASE("history: 200 steps are kept, the oldest go first") {
        History history(named("0"), "start");
        for (int i = 1; i <= 250; ++i) history.commit(named(std::to_string(i)), "step");
        int steps = 0;
        while (history.can_undo()) {
            history.undo();
            ++steps;
        }
        CHECK(steps == 200);
        CHECK(history.current().name == "50");
        while (history.can_redo()) history.redo();
        CHECK(history.current().name == "250");
    }

    TEST_CASE("history: pictures are counted once, and the oldest go when there are too many pixels") {
        const auto painted = [](int step) {
            auto raster = std::make_shared<Raster>();
            raster->width = raster->height = limits::raster_max;
            raster->values.assign(std::size_t{limits::raster_max} * limits::raster_max,
                                  static_cast<float>(step));
            Design design;
            design.distribution.layers[0].lobe = PaintedLobe{{{}, raster}};
            return design;
        };
        constexpr std::size_t most =
            History::pixels_max / (std::size_t{limits::raster_max} * limits::raster_max);
        History history(painted(0), "start");
        Design renamed = history.current();
        for (int i = 0; i < 20; ++i) {
            renamed.name += 'x';
            history.commit(renamed, "step");
        }
        for (std::size_t i = 1; i < most + 5; ++i) history.commit(painted(static_cast<int>(i)), "step");
        std::size_t steps = 0;
        for (; history.can_undo(); ++steps) history.undo();
        CHECK(steps == most - 1);
        const auto& lobe = std::get<PaintedLobe>(history.current().distribution.layers[0].lobe);
        CHECK(lobe.image.raster->values[0] == 5);
    }

    TEST_CASE("history: each state is called by what made it, and can be gone to by its number") {
        History history(named("a"), "start");
        history.commit(named("b"), "Tilt");
        history.commit(named("b"), "nothing");
        history.begin(named("c"), "Preset C");
        REQUIRE(history.states().size() == 3);
        CHECK(history.states()[0].what == "start");
        CHECK(history.states()[1].what == "Tilt");
        CHECK(history.states()[2].what == "Preset C");
        const auto first = history.states()[0].number, last = history.states()[2].number;
        history.go_to(first);
        CHECK(history.current().name == "a");
        CHECK(history.position() == 0);
        history.go_to(last);
        CHECK(history.current().name == "c");
        CHECK(history.document() == 1);
        history.undo();
        history.commit(named("d"), "Weight");
        history.go_to(last);  // it is gone, and its number is nobody else's
        CHECK(history.current().name == "d");
        CHECK(history.states()[2].number != last);
    }

    TEST_CASE("history: it lists every other document that is not saved, the newest first") {
        History history(named("a"), "start");
        history.begin(named("b"), "Preset B");
        history.begin(named("c"), "Preset C");
        history.commit(named("c2"), "Weight");
        history.begin(named("d"), "Preset D");
        std::string names;
        for (const History::State* state : history.unsaved_elsewhere()) names += state->design.name + " ";
        CHECK(names == "c2 a ");
        history.undo();
        history.mark_saved();
        history.redo();
        REQUIRE(history.unsaved_elsewhere().size() == 1);
        CHECK(history.unsaved_elsewhere()[0]->design.name == "a");
    }

    TEST_CASE("history: it knows whether the current design is the one on disk") {
        History history(named("a"), "start");
        CHECK_FALSE(history.saved());
        history.mark_saved();
        CHECK(history.saved());
        history.commit(named("b"), "step");
        CHECK_FALSE(history.saved());
        history.undo();
        CHECK(history.saved());
        history.commit(named("c"), "step");
        history.mark_saved();
        history.undo();
        CHECK_FALSE(history.saved());
        history.commit(named("c"), "step");
        CHECK(history.saved());
    }
}
