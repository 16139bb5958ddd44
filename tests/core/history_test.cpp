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
        History history(named("a"));
        CHECK_FALSE(history.can_undo());
        CHECK_FALSE(history.can_redo());
        history.commit(named("b"));
        history.commit(named("c"));
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
        History history(named("a"));
        history.commit(named("b"));
        history.undo();
        history.commit(named("a"));
        CHECK(history.can_redo());
        history.commit(named("c"));
        CHECK_FALSE(history.can_redo());
        history.undo();
        CHECK(history.current().name == "a");
        CHECK_FALSE(history.can_undo());
    }

    TEST_CASE("history: an equal picture behind another pointer is no new step") {
        const auto raster = [](float value) { return std::make_shared<const Raster>(Raster{1, 1, {value}}); };
        Design design;
        design.distribution.layers[0].lobe = PaintedLobe{{{}, raster(1)}};
        History history(design);
        design.distribution.layers[0].lobe = PaintedLobe{{{}, raster(1)}};
        history.commit(design);
        CHECK_FALSE(history.can_undo());
        design.distribution.layers[0].lobe = PaintedLobe{{{}, raster(2)}};
        history.commit(design);
        CHECK(history.can_undo());
    }

    TEST_CASE("history: 200 steps are kept, the oldest go first") {
        History history(named("0"));
        for (int i = 1; i <= 250; ++i) history.commit(named(std::to_string(i)));
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
        History history(painted(0));
        Design renamed = history.current();
        for (int i = 0; i < 20; ++i) {
            renamed.name += 'x';
            history.commit(renamed);
        }
        for (std::size_t i = 1; i < most + 5; ++i) history.commit(painted(static_cast<int>(i)));
        std::size_t steps = 0;
        for (; history.can_undo(); ++steps) history.undo();
        CHECK(steps == most - 1);
        const auto& lobe = std::get<PaintedLobe>(history.current().distribution.layers[0].lobe);
        CHECK(lobe.image.raster->values[0] == 5);
    }

    TEST_CASE("history: it knows whether the current design is the one on disk") {
        History history(named("a"));
        CHECK_FALSE(history.saved());
        history.mark_saved();
        CHECK(history.saved());
        history.commit(named("b"));
        CHECK_FALSE(history.saved());
        history.undo();
        CHECK(history.saved());
        history.commit(named("c"));
        history.mark_saved();
        history.undo();
        CHECK_FALSE(history.saved());
        history.commit(named("c"));
        CHECK(history.saved());
    }
}
