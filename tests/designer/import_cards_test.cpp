// A picture that comes in: read beside the window, shown as cards, chosen by hand or by what it is.
#include <doctest/doctest.h>

#include <fstream>
#include <stop_token>
#include <string>
#include <vector>

#include "app/designer/import_job.h"
#include "core/image/image_file.h"
#include "core/model/facet_distribution.h"
#include "tests/designer/folder_rig.h"

using namespace nacre;
using test::FolderRig;
namespace fs = std::filesystem;

namespace {

// Leaning to the right by 20 degrees in the left half, to the left in the right one.
void write_ridge(const fs::path& file, int side) {
    const double sine = std::sin(0.35), cosine = std::cos(0.35);
    std::vector<float> rgb;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            for (const double n : {column < side / 2 ? sine : -sine, 0.0, cosine})
                rgb.push_back(static_cast<float>(0.5 + 0.5 * n));
    write_image(file, {side, side}, rgb);
}

void write_sky(const fs::path& file) {
    std::vector<float> rgb;
    for (int i = 0; i < 64 * 32; ++i) rgb.insert(rgb.end(), {0.3f, 0.6f, 0.02f * static_cast<float>(i)});
    write_image(file, {64, 32}, rgb);
}

bool has(const FolderRig& r, const char* item) { return r.stage.items().rectangle(item).has_value(); }

// What the worker publishes last.
ImportSight seen(ImportWorker& worker, const ImportRequest& request, int* published = nullptr) {
    ImportSight last;
    int count = 0;
    worker.work(request, std::stop_token(), [&](ImportSight sight) {
        last = std::move(sight);
        ++count;
    });
    if (published != nullptr) *published = count;
    return last;
}

// Mean place of the light in a preview, x right and y up, of its half side.
glm::dvec2 middle(const HemispherePicture& picture) {
    glm::dvec2 sum(0);
    double mass = 0;
    for (int row = 0; row < picture.size.y; ++row)
        for (int column = 0; column < picture.size.x; ++column) {
            const auto* pixel = &picture.rgba[static_cast<std::size_t>(row * picture.size.x + column) * 4];
            const double light = pixel[3] == 255 ? pixel[0] : 0;
            sum += light * glm::dvec2(2.0 * (column + 0.5) / picture.size.x - 1,
                                      1 - 2.0 * (row + 0.5) / picture.size.y);
            mass += light;
        }
    return sum / mass;
}

}  // namespace

TEST_CASE("import: a picture is read while the window goes on, and Escape gives it up") {
    FolderRig r;
    write_ridge(r.folder / "large.exr", 1500);
    const Design before = r.document().design;
    take_file(r.designer(), r.folder / "large.exr");
    r.stage.frame(false);
    CHECK(r.designer().pictures.reading());
    CHECK(has(r, "Cancel"));
    CHECK(talking(r.designer()));
    r.play("frames 1\nkey Escape\nframes 3");
    CHECK(!r.designer().pictures.talking());
    r.designer().pictures.wait();
    r.play("frames 3");
    CHECK(!r.designer().pictures.talking());
    CHECK(r.document().design == before);
    // The newest file counts, and what was given up does not come back with it.
    write_sky(r.folder / "sky.exr");
    take_file(r.designer(), r.folder / "large.exr");
    r.stage.frame(false);
    r.play(r.drop("sky.exr") + "key Enter\nwait\nframes 3");
    CHECK(r.document().design == before);
    REQUIRE(r.designer().scene.environment.picture);
}

TEST_CASE("import: what is being made is given up too, and nothing of it comes") {
    FolderRig r;
    write_ridge(r.folder / "large.exr", 1500);
    const Design before = r.document().design;
    r.play(r.drop("large.exr") + r.card("Normals"));
    r.play("key Enter");
    r.play("key Escape\nframes 2");
    r.designer().pictures.wait();
    r.play("frames 3");
    CHECK(!r.designer().pictures.talking());
    // Where the worker was quicker than the key it came whole.
    CHECK((r.document().design == before || (r.layers().size() == 2 && r.layers()[1].source)));
}

TEST_CASE("import: the likely card is chosen, and Enter takes it") {
    FolderRig r;
    write_ridge(r.folder / "ridge.exr", 64);
    r.play("click \"Presets\"\n" + r.drop("ridge.exr") + "key Enter\nwait\nframes 3");
    REQUIRE(r.layers().size() == 2);
    REQUIRE(r.layers()[1].source);
    CHECK(r.layers()[1].source->as == SourceUse::normals);
    CHECK(has(r, "Smoothing"));  // the panel with its settings has come to the front
    CHECK(r.layers()[1].source->image == r.folder / "ridge.exr");
    write_sky(r.folder / "sky.exr");
    r.play(r.drop("sky.exr") + "key Enter\nwait\nframes 3");
    CHECK(r.layers().size() == 2);
    CHECK(r.designer().scene.environment.picture);
    CHECK(has(r, "Environment"));
}

TEST_CASE("import: arrows go from card to card, a double click takes one, Escape none") {
    FolderRig r;
    write_ridge(r.folder / "ridge.exr", 64);
    r.play(r.drop("ridge.exr") + "key Right\nkey Enter\nwait\nframes 3");
    REQUIRE(r.layers().size() == 2);
    REQUIRE(r.layers()[1].source);
    CHECK(r.layers()[1].source->as == SourceUse::heights);
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.layers().size() == 1);
    r.play(r.drop("ridge.exr") + "key Left\nkey Left\nkey Left\nkey Enter\nwait\nframes 3");
    REQUIRE(r.layers().size() == 2);
    CHECK(r.layers()[1].source->as == SourceUse::stamp);
    r.play("click \"Layer 1\"\nframes 30\n" + r.drop("ridge.exr") +
           "click \"As Modulation\"\nclick \"As Modulation\"\nwait\nframes 3");
    CHECK(!r.designer().pictures.talking());
    CHECK(r.layers()[0].modulation.has_value());
    const Design before = r.document().design;
    r.play(r.drop("ridge.exr") + "key Escape\nframes 3");
    CHECK(!r.designer().pictures.talking());
    CHECK(r.document().design == before);
}

TEST_CASE("import: the menu asks for a picture and shows the same cards") {
    FolderRig r;
    write_ridge(r.folder / "ridge.exr", 64);
    r.play("key Ctrl+I\nframes 3");
    CHECK(r.designer().pictures.talking());
    r.play("key Ctrl+A\ntext \"" + (r.folder / "ridge.exr").string() + "\"\nkey Enter\nframes 3");
    r.designer().pictures.wait();
    r.play("frames 3");
    CHECK(has(r, "As Normals"));
    r.play(r.import("Normals"));
    CHECK(r.layers().size() == 2);
}

TEST_CASE("import: a design of all the layers that it can have takes a modulation or an environment alone") {
    FolderRig r;
    write_ridge(r.folder / "ridge.exr", 64);
    r.layers().resize(limits::layers_max);
    r.document().commit();
    r.play(r.drop("ridge.exr") + "move \"As Normals\"\nframes 60");
    CHECK(r.stage.items().tooltip() == "The design has 16 layers, which is as many as there can be.");
    r.play("key Enter\nframes 3");
    CHECK(r.designer().pictures.talking());
    r.play(r.import("Modulation"));
    CHECK(r.layers().size() == limits::layers_max);
    CHECK(r.layers()[0].modulation.has_value());
}

TEST_CASE("import: each card shows the highlight that would come of it, upright, and follows the settings") {
    const test::TemporaryFolder folder;
    // White at the right alone.
    std::vector<float> rgb;
    for (int i = 0; i < 32 * 32; ++i) rgb.insert(rgb.end(), 3, i % 32 < 16 ? 0.0f : 1.0f);
    write_image(folder / "right.exr", {32, 32}, rgb);
    ImportWorker worker;
    ImportRequest request;
    request.settings.image = folder / "right.exr";
    request.modulated.lobe = UniformLobe{};
    int published = 0;
    ImportSight sight = seen(worker, request, &published);
    CHECK(published == static_cast<int>(import_uses));
    const auto preview = [&](ImportUse use) { return *sight.previews[static_cast<std::size_t>(use)]; };
    CHECK(middle(preview(ImportUse::stamp).picture).x > 0.1);
    CHECK(middle(preview(ImportUse::modulation).picture).x > 0.2);
    CHECK(preview(ImportUse::environment).refusal == "32 x 32 pixels, must be twice as wide as high.");
    CHECK(preview(ImportUse::heights).refusal.empty());
    // As the canvas draws that layer.
    ImportedPicture picture(folder / "right.exr");
    Distribution alone;
    alone.layers[0].lobe = PaintedLobe{{{}, made_raster(picture, request.settings).raster}};
    const FacetDistribution p(alone);
    const HemisphereView view(HemisphereCamera{}, {ImportWorker::side, ImportWorker::side});
    CHECK(preview(ImportUse::stamp).picture.rgba ==
          density_picture(&p, view, {.peak = peak_density(p)}, 1).rgba);
    request.settings.rotation = 90;
    request.by_look = false;
    sight = seen(worker, request);
    CHECK(middle(preview(ImportUse::stamp).picture).y > 0.1);
    CHECK(middle(preview(ImportUse::modulation).picture).y > 0.2);
}

TEST_CASE("import: what is no picture is said in words before its path") {
    FolderRig r;
    std::ofstream(r.folder / "notes.txt") << "not a picture, but words\n";
    std::ofstream(r.folder / "paper.pdf") << "%PDF-1.4\n1 0 obj\n";
    std::ofstream(r.folder / "empty.png");
    std::ofstream(r.folder / "sheet.ods") << "PK\x03\x04";
    fs::create_directory(r.folder / "pictures");
    write_ridge(r.folder / "whole.png", 64);
    const std::string whole = test::read_all(r.folder / "whole.png");
    test::write_all(r.folder / "half.png", whole.substr(0, whole.size() / 2));
    const std::pair<const char*, const char*> cases[] = {
        {"notes.txt", "\u201cnotes.txt\u201d cannot be used. A text, "},
        {"paper.pdf", "\u201cpaper.pdf\u201d cannot be used. A PDF document, "},
        {"empty.png", "\u201cempty.png\u201d cannot be used. An empty file, "},
        {"sheet.ods", "\u201csheet.ods\u201d cannot be used. An archive, "},
        {"pictures", "\u201cpictures\u201d is a folder. Choose a picture in it."},
        {"gone.png", "\u201cgone.png\u201d cannot be used. No such file or directory."},
        {"half.png", "\u201chalf.png\u201d cannot be used. "}};
    for (const auto& [name, words] : cases) {
        CAPTURE(name);
        r.play(r.drop(name));
        const std::string said = r.designer().pictures.problem();
        CHECK(said.starts_with(words));
        CHECK(said.ends_with("\n\n" + (r.folder / name).string()));
        r.play("key Enter\nframes 3");
        CHECK(!r.designer().pictures.talking());
    }
}

TEST_CASE("import: every part of the dialog and of the layer that it makes explains itself") {
    FolderRig r;
    write_ridge(r.folder / "ridge.exr", 64);
    const auto explained = [&](std::initializer_list<const char*> names) {
        for (const char* name : names) {
            CAPTURE(name);
            r.play("move \"" + std::string(name) + "\"\nframes 40");
            CHECK(r.stage.items().tooltip().size() > 10);
        }
    };
    r.play(r.drop("ridge.exr"));
    explained({"As Stamp", "As Normals", "As Heights", "As Modulation", "As Environment map", "Import",
               "Cancel", "Up (OpenGL)", "Down (DirectX)", "0.5 is zero", "Signed", "x, y and z", "x and y",
               "Smoothing", "Picture rotation", "Flip picture"});
    r.play(r.card("Heights"));
    explained({"Height"});
    r.play(r.card("Stamp"));
    explained({"Picture size"});
    r.play("frames 30\n" + r.import("Normals"));
    explained({"Down (DirectX)", "Smoothing", "Picture rotation", "Flip picture", "Read picture again"});
    // Whole, also where the panel is narrow.
    CHECK(r.stage.items().rectangle("Down (DirectX)")->z <= r.stage.items().rectangle("Smoothing")->z);
}

TEST_CASE("import: a stamp and an environment that cannot be read are said in words too") {
    FolderRig r;
    std::ofstream(r.folder / "notes.txt") << "not a picture, but words\n";
    r.designer().stamps.want(r.folder / "notes.txt");
    r.play("wait\nframes 3");
    CHECK(r.designer().stamps.problem().starts_with("\u201cnotes.txt\u201d cannot be used. A text, "));
    r.play("key Enter\nframes 3");
    r.designer().environment.want((r.folder / "notes.txt").string());
    r.play("wait\nframes 3");
    CHECK(r.designer().environment.problem().starts_with("\u201cnotes.txt\u201d cannot be used. A text, "));
}
