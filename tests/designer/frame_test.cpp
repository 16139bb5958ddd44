// What a frame shows is one value, made of what the hand has done in it.
#include <doctest/doctest.h>

#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::Rig;

namespace {

void check_shown(Rig& r) {
    const Frame& frame = r.designer().frame;
    CHECK(frame.design == r.document().design);
    REQUIRE(frame.p);
    const FacetDistribution p(r.document().design.distribution);
    for (const dvec3& h : {dvec3(0, 0, 1), dvec3(0.6, 0, 0.8), dvec3(0, -0.6, 0.8)})
        CHECK(frame.p->density(h) == doctest::Approx(p.density(h)).epsilon(1e-6));
}

}  // namespace

TEST_CASE(
    "frame: what is painted, on the canvas or on the sphere, is shown in the frame in which it is painted") {
    for (const char* picture : {"Canvas", "Preview"}) {
        CAPTURE(picture);
        Rig r;
        const std::string at = std::string("\"") + picture + "\":";
        r.play("wait\nkey B\nmove " + at + "0.5,0.5\nframes 2");
        check_shown(r);
        const Design before = r.document().design;
        r.play("down left");
        check_shown(r);
        for (const char* to : {"0.52,0.5", "0.55,0.52", "0.55,0.6"}) {
            r.play("move " + at + to);
            check_shown(r);
        }
        CHECK(r.document().design != before);
        r.play("up left");
        check_shown(r);
    }
}

TEST_CASE("frame: it shows the layers that are shown, and is settled while nothing moves") {
    Rig r;
    r.play("wait\nclick \"New painted layer\"\nframes 2\nclick \"Layer 1 solo\"\nframes 2");
    CHECK(r.designer().frame.settled);
    CHECK(r.designer().frame.design.distribution ==
          ui::shown(r.designer().layers, r.document().design.distribution));
    r.play("key 1\nframes 2");
    r.play("drag \"Width x\":0.5 \"Width x\":0.3 5\nmove \"Width x\":0.3\ndown left\nmove \"Width x\":0.4");
    CHECK(!r.designer().frame.settled);
    r.play("up left");
    CHECK(r.designer().frame.settled);
}
