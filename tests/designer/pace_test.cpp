// When the window draws, on a clock of the test's own.
#include <doctest/doctest.h>

#include <initializer_list>

#include "app/desktop/pace.h"

using namespace nacre;

namespace {

struct Clock {
    Pace pace;
    double now = 100;

    // One look: waits as long as it is told to, or until `event` seconds of that have gone by.
    bool look(double event = -1, bool moves = false, bool typing = false) {
        const double wait = pace.wait(now, moves);
        const bool noticed = event >= 0 && event <= wait;
        now += noticed ? event : wait;
        return pace.due(now, noticed, typing);
    }
    void settle() {
        for (int i = 0; i < 300 && pace.wait(now, false) < 0.1; ++i) look();
    }
};

}  // namespace

TEST_CASE("pace: an event is drawn whenever in the wait it comes, also at its very end") {
    for (const double part : {0.0, 0.3, 0.9, 0.951, 0.98, 0.9999, 1.0}) {
        CAPTURE(part);
        Clock clock;
        clock.settle();
        const double wait = clock.pace.wait(clock.now, false);
        bool drawn = clock.look(part * wait);
        for (int i = 0; i < 3 && !drawn; ++i) drawn = clock.look();
        CHECK(drawn);
    }
}

TEST_CASE("pace: events in a row are drawn sixty times a second and the last of them too") {
    Clock clock;
    clock.settle();
    const double begin = clock.now;
    int frames = 0;
    for (int i = 0; i < 1000; ++i) frames += clock.look(0.001) ? 1 : 0;
    const double seconds = clock.now - begin;
    CHECK(frames >= 50 * seconds);
    CHECK(frames <= 62 * seconds);
    CHECK((clock.look() || clock.look()));
}

TEST_CASE("pace: nothing is drawn while nothing happens, and a cursor blinks where text is typed") {
    Clock clock;
    clock.settle();
    for (int i = 0; i < 20; ++i) CHECK(!clock.look());
    CHECK(clock.look(-1, false, true));
    CHECK(clock.pace.wait(clock.now, false) >= 0.4);
    CHECK(clock.look(-1, true));
    CHECK(clock.pace.wait(clock.now, false) < 0.02);
}
