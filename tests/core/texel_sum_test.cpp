#include "tests/core/texel_sums.h"

#include <doctest/doctest.h>

#include "core/bake/baker.h"
#include "core/design/design_file.h"
#include "core/design/history.h"
#include "core/paint/painted_layer.h"
#include "core/paint/stroke.h"
#include "tests/core/designs.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;

// What is painted is what is baked.
TEST_CASE(
    "texels: H, N and g of the tables are their sums, after a stroke, after undo, after save and reopen") {
    Baker baker;
    const auto baked = [&](const Design& design) {
        const auto tables = baker.bake(design, {.quality = Quality::draft, .threads = 1});
        const Layer& layer = design.distribution.layers[0];
        test::check_texel_sums(*tables->distribution, layer);
        CHECK(glm::length(tables->mean - tables->distribution->mean()) < 1e-15);
    };
    Design design = test::design_of(PaintedLobe{{{}, blank_raster()}}, 20, 70, 15);
    Layer& layer = design.distribution.layers[0];
    const auto stroke = [&](PaintTool tool, SymmetryKind symmetry, dvec3 from, dvec3 to) {
        const auto before = std::get<PaintedLobe>(layer.lobe).image.raster;
        Stroke drawn(*before, {tool, {9, 0.3, 0.7}, {symmetry, 6}, nullptr}, glm::normalize(from));
        drawn.move_to(glm::normalize(to));
        set_raster(layer, drawn.raster(), raster_mass(*before), 1);
    };
    stroke(PaintTool::paint, SymmetryKind::none, {0.1, 0.2, 1}, {0.6, -0.2, 0.5});
    History history(design, "start");
    baked(design);
    stroke(PaintTool::paint, SymmetryKind::turns, {-0.5, 0.1, 0.4}, {-0.2, -0.4, 1});
    history.commit(design, "step");
    baked(design);
    stroke(PaintTool::smear, SymmetryKind::none, {0.3, 0.1, 0.8}, {-0.6, 0.3, 0.2});
    stroke(PaintTool::erase, SymmetryKind::mirror_x, {0.6, -0.2, 0.5}, {0.5, 0.2, 0.5});
    history.commit(design, "step");
    baked(design);
    history.undo();
    baked(history.current());
    history.undo();
    baked(history.current());
    history.redo();
    history.redo();
    const test::TemporaryFolder folder;
    save_design(history.current(), folder / "painted.nacre");
    const Design again = load_design(folder / "painted.nacre");
    CHECK(again == design);
    baked(again);
}
