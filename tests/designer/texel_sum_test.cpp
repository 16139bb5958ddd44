// What is painted is what is shown: p of the canvas against the sum over the texels.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/texel_sums.h"
#include "tests/designer/rig.h"

using namespace nacre;

TEST_CASE(
    "texels: H, N and g of the canvas are their sums, after strokes, grab, balance, undo and reopening") {
    test::Rig r;
    const auto check = [&] {
        r.play("frames 2");
        REQUIRE(r.layers().size() == 1);
        REQUIRE(r.designer().frame.p);
        test::check_texel_sums(*r.designer().frame.p, r.layers()[0]);
        test::check_texel_sums(FacetDistribution(r.document().design.distribution), r.layers()[0]);
    };
    r.play("click \"New painted layer\"\ndrag \"Canvas\":@20,10 \"Canvas\":@60,80 6\nframes 30");
    r.play("click \"Layer 1\"\nclick \"Delete layer\"\nframes 30");
    check();
    r.play("click \"Smear\"\ndrag \"Canvas\":@40,45 \"Canvas\":@10,200 4\nframes 30");
    r.play("click \"Ring\"\ndrag \"Canvas\":@40,220 \"Canvas\":@60,230 3\nframes 30");
    check();
    r.play("click \"Grab\"\ndrag \"Canvas\":@30,30 \"Canvas\":@45,120 5\nframes 2");
    check();
    const Design before = r.document().design;
    r.play("click \"Balance\"");
    CHECK(r.document().design != before);
    check();
    CHECK(std::hypot(r.designer().frame.p->mean().x, r.designer().frame.p->mean().y) < 1e-9);
    r.play("key Ctrl+Z");
    CHECK(r.document().design == before);
    check();
    r.play("key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Y");
    check();
    const test::TemporaryFolder folder;
    save_design(r.document().design, folder / "painted.nacre");
    const Design again = load_design(folder / "painted.nacre");
    CHECK(again == r.document().design);
    test::check_texel_sums(FacetDistribution(again.distribution), again.distribution.layers[0]);
}
