#include "core/design/design_file.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>

#include "core/image/picture.h"
#include "tests/core/random_design.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

void write_grey(const fs::path& file, const std::vector<float>& values) {
    const int side = static_cast<int>(std::lround(std::sqrt(double(values.size()))));
    const auto output = OIIO::ImageOutput::create(file.string());
    REQUIRE(output);
    REQUIRE(output->open(file.string(), OIIO::ImageSpec(side, side, 1, OIIO::TypeDesc::FLOAT)));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
    REQUIRE(output->close());
}

Picture picture_file(const fs::path& file) {
    return {file, std::make_shared<const Raster>(load_picture(file, "test", "picture"))};
}

Picture held(int side, const std::vector<float>& values) {
    return {{}, std::make_shared<const Raster>(Raster{side, side, values})};
}

Design parse(std::string_view text) { return parse_design(text, "test.nacre", "/"); }

// With each kind of a set in turn, made by `with` from the default design.
template <class Set, class With>
void check_versions(const With& with) {
    for (std::size_t i = 0; i < KindSet<Set>::count; ++i) {
        const Set kind = KindSet<Set>::made(i);
        Design design;
        with(design, kind);
        CAPTURE(kind_name(kind));
        CHECK(version_of(design) == file_version(kind));
    }
}

}  // namespace

TEST_SUITE("design") {
    TEST_CASE("design: a file with the version alone is the default design") {
        CHECK(parse("{\"nacre\": 1}") == Design{});
        CHECK(parse("{\"nacre\": 1, \"distribution\": {\"layers\": [{}]}, \"fresnel\": {}, \"diffuse\": {}, "
                    "\"shadowing\": {}}") == Design{});
    }

    TEST_CASE("design: every key reaches its place") {
        const Design design = parse(R"({"nacre": 1, "name": "N", "note": "why",
            "distribution": {"mean_cosine_scale": 2, "layers": [
                {"name": "a", "enabled": false, "lobe": "gaussian", "weight": 0.7, "sigma_x": 0.1,
                 "sigma_y": "infinity", "tilt": 1, "azimuth": 2, "rotation": 3},
                {"lobe": "inverse_gaussian", "sigma": 0.6}, {"lobe": "ggx", "alpha_x": 0.3, "alpha_y": 0.4},
                {"lobe": "beckmann", "alpha_x": 0.5}, {"lobe": "uniform", "domain": "sphere"},
                {"lobe": "curve", "points": [[0, 0], [20, 1.5], [30, 0]]},
                {"lobe": "painted", "image": {"width": 2, "height": 2, "values": [1, 2, 3, 4]},
                 "modulation": {"strength": 0.5, "image": {"width": 1, "height": 1, "values": [0.5]}}}]},
            "shadowing": {"model": "correlated", "width": 20, "clamp": false},
            "fresnel": {"model": "conductor", "eta": [1, 2, 3], "k": [4, 5, 6]},
            "diffuse": {"model": "lambertian", "kd": 0.25, "ks": 0.75, "albedo": [0.1, 0.2, 0.3]}})");
        CHECK(design.name == "N");
        CHECK(design.note == "why");
        CHECK(design.distribution.mean_cosine_scale == 2);
        const std::vector<Layer>& layers = design.distribution.layers;
        REQUIRE(layers.size() == 7);
        CHECK(layers[0] == Layer{"a", false, GaussianLobe{0.1, limits::infinity}, 0.7, 3, 1, 2, {}});
        CHECK(layers[1].lobe == Lobe{InverseGaussianLobe{0.6}});
        CHECK(layers[2].lobe == Lobe{GgxLobe{0.3, 0.4}});
        CHECK(layers[3].lobe == Lobe{BeckmannLobe{0.5, BeckmannLobe{}.alpha_y}});
        CHECK(layers[4].lobe == Lobe{UniformLobe{UniformDomain::sphere}});
        CHECK(layers[5].lobe == Lobe{CurveLobe{{{0, 0}, {20, 1.5}, {30, 0}}}});
        CHECK(layers[6].lobe == Lobe{PaintedLobe{held(2, {1, 2, 3, 4})}});
        REQUIRE(layers[6].modulation);
        CHECK(*layers[6].modulation == Modulation{held(1, {0.5f}), 0.5});
        CHECK(design.shadowing == Shadowing{CorrelatedMasking{20}, false});
        CHECK(design.fresnel == Fresnel{ConductorFresnel{{1, 2, 3}, {4, 5, 6}}});
        CHECK(design.diffuse == Diffuse{LambertianDiffuse{0.25, 0.75, {0.1, 0.2, 0.3}}});
        CHECK(parse(R"({"nacre": 1, "shadowing": {"model": "smith_correlated"}})").shadowing.model ==
              MaskingModel(SmithCorrelatedMasking{}));
    }

    TEST_CASE("design: what is written is what the contract shows") {
        Design design;
        design.name = "Satin";
        Layer layer;
        layer.lobe = GaussianLobe{0.1, limits::infinity};
        layer.weight = 0.7;
        design.distribution.layers = {layer, Layer{}};
        design.distribution.layers[1].lobe = PaintedLobe{held(2, {0, 0.1f, 1, 0.25f})};
        design.diffuse = CoupledDiffuse{{0.4, 0.05, 0.1}};
        CHECK(design_json(design, "/") == R"({
  "nacre": 1,
  "name": "Satin",
  "distribution": {
    "layers": [
      {"lobe": "gaussian", "weight": 0.7, "sigma_x": 0.1, "sigma_y": "infinity", "tilt": 0, "azimuth": 0, "rotation": 0},
      {"lobe": "painted", "weight": 1, "tilt": 0, "azimuth": 0, "rotation": 0, "image": {"width": 2, "height": 2, "values": [
        0, 0.1,
        1, 0.25
      ]}}
    ],
    "mean_cosine_scale": 1
  },
  "shadowing": {"model": "uncorrelated", "clamp": true},
  "fresnel": {"model": "schlick", "f0": [0.05, 0.05, 0.05]},
  "diffuse": {"model": "coupled", "albedo": [0.4, 0.05, 0.1]}
}
)");
    }

    TEST_CASE("design: random designs come back equal from their file") {
        const TemporaryFolder folder;
        fs::create_directory(folder / "pictures of ü");
        write_grey(folder / "a.exr", {0.25f, 0.5f, 1, 2});
        write_grey(folder / "pictures of ü/b \"quoted\".exr", {3});
        const std::vector<Picture> files = {picture_file(folder / "a.exr"),
                                            picture_file(folder / "pictures of ü/b \"quoted\".exr")};
        const bool holds = rc::check("save, then load", [&] {
            const Design design = random_design(files);
            const fs::path file = folder / "design.nacre";
            save_design(design, file);
            const Design back = load_design(file);
            RC_ASSERT(back == design);
            RC_ASSERT(design_json(back, folder.path()) == read_all(file));
        });
        CHECK(holds);
        CHECK(folder.size() == 3);
    }

    TEST_CASE("design: floats that a double would round twice come back all the same") {
        // The one float whose shortest digits, read as a double, lie halfway to its neighbour.
        const float twice_rounded = std::bit_cast<float>(0x15AE43FDu);
        Design design;
        design.distribution.layers[0].lobe =
            PaintedLobe{held(2, {twice_rounded, 0.1f, 3.4028235e38f, 1e-45f})};
        CHECK(parse(design_json(design, "/")) == design);
    }

    TEST_CASE("design: a negative zero is written as zero") {
        Design design;
        design.distribution.layers[0].azimuth = -0.0;
        CHECK(design_json(design, "/").find("\"azimuth\": 0,") != std::string::npos);
        CHECK_FALSE(
            std::signbit(parse("{\"nacre\": 1, \"distribution\": {\"layers\": [{\"azimuth\": -0.0}]}}")
                             .distribution.layers[0]
                             .azimuth));
    }

    TEST_CASE("design: a picture is named relative to the file, wherever that goes") {
        const TemporaryFolder folder;
        fs::create_directories(folder / "designs/deep");
        fs::create_directory(folder / "pictures");
        write_grey(folder / "pictures/a.exr", {1});
        Design design;
        design.distribution.layers[0].lobe = PaintedLobe{picture_file(folder / "pictures/a.exr")};
        save_design(design, folder / "a.nacre");
        CHECK(read_all(folder / "a.nacre").find("\"image\": \"pictures/a.exr\"") != std::string::npos);
        const Design first = load_design(folder / "a.nacre");
        save_design(first, folder / "designs/deep/b.nacre");
        CHECK(read_all(folder / "designs/deep/b.nacre").find("\"image\": \"../../pictures/a.exr\"") !=
              std::string::npos);
        CHECK(load_design(folder / "designs/deep/b.nacre") == design);
        fs::create_directory_symlink(folder / "designs/deep", folder / "link");
        CHECK(load_design(folder / "link/b.nacre") == design);
        save_design(design, folder / "link/c.nacre");
        CHECK(load_design(folder / "designs/deep/c.nacre") == design);
    }

    TEST_CASE("design: a picture whose path is not UTF-8 cannot be saved, and the old file stays") {
        const TemporaryFolder folder;
        write_all(folder / "a.nacre", "old");
        Design design;
        design.distribution.layers[0].modulation = Modulation{{folder / "\xFF.exr", nullptr}, 1};
        const std::string line = user_error_of([&] { save_design(design, folder / "a.nacre"); });
        CHECK(line.find(": distribution.layers[0].modulation.image: ") != std::string::npos);
        CHECK(line.find("\\xff.exr") != std::string::npos);
        CHECK(read_all(folder / "a.nacre") == "old");
    }

    TEST_CASE("a file has the version of the kinds that it holds") {
        check_versions<Lobe>([](Design& d, const Lobe& kind) { d.distribution.layers[0].lobe = kind; });
        check_versions<MaskingModel>([](Design& d, const MaskingModel& kind) { d.shadowing.model = kind; });
        check_versions<Fresnel>([](Design& d, const Fresnel& kind) { d.fresnel = kind; });
        check_versions<Diffuse>([](Design& d, const Diffuse& kind) { d.diffuse = kind; });
        check_versions<Multibounce>([](Design& d, const Multibounce& kind) { d.multibounce = kind; });
        check_versions<Coat>([](Design& d, const Coat& kind) { d.coat = kind; });
    }

    TEST_CASE("design: saving where it cannot be saved") {
        const TemporaryFolder folder;
        const std::string line = user_error_of([&] { save_design(Design{}, folder / "missing/a.nacre"); });
        CHECK(line.find("missing/a.nacre: write: ") != std::string::npos);
        CHECK(folder.size() == 0);
    }
}
