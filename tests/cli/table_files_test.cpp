// What a stranger makes of the written tables: this follows manifest.json and nothing else.
#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;
using Json = nlohmann::json;

struct Table {
    int width = 0, height = 0, channels = 0;
    std::vector<float> texels;

    double at(int column, int row, int channel = 0) const {
        return static_cast<double>(
            texels.at(static_cast<std::size_t>((row * width + column) * channels + channel)));
    }
};

Table read_table(const std::filesystem::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    REQUIRE(input);
    const OIIO::ImageSpec& spec = input->spec();
    CHECK(spec.format == OIIO::TypeDesc::FLOAT);
    CHECK(spec.get_string_attribute("compression") == "zip");
    Table table{spec.width, spec.height, spec.nchannels, {}};
    CHECK((spec.channelnames[0] == "Y" || spec.channelnames[0] == "R"));
    table.texels.resize(static_cast<std::size_t>(spec.width * spec.height * spec.nchannels));
    REQUIRE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, table.texels.data()));
    return table;
}

class Stranger {
  public:
    explicit Stranger(const std::filesystem::path& folder)
        : manifest_(Json::parse(read_all(folder / "manifest.json"))) {
        for (const Json& table : manifest_.at("tables")) {
            const Table read = read_table(folder / table.at("file").get<std::string>());
            CHECK(read.width == table.at("width"));
            CHECK(read.height == table.at("height"));
            tables_[table.at("quantity")] = read;
        }
    }

    struct Answer {
        double g, P, R0, R1;
    };

    Answer evaluate(glm::dvec3 k) const {
        const Json& constants = manifest_.at("constants");
        const std::string symmetry = manifest_.at("symmetry");
        const bool clamp = manifest_.at("material").at("clamp");
        const auto number = [&](const char* name, std::size_t i) {
            return constants.at(name).at(i).get<double>();
        };
        double x = number("axis", 0) * k.x + number("axis", 1) * k.y;
        double y = number("axis", 0) * k.y - number("axis", 1) * k.x;
        if (symmetry == "quarter") x = std::fabs(x);
        if (symmetry == "quarter" || symmetry == "half") y = std::fabs(y);
        const double along = number("stretch", 0) * x, across = number("stretch", 1) * y;
        const double lean = constants.at("lean"), radius = std::hypot(x, y);
        double psi = turns(number("stretch", 0) * (x + lean * radius), across * std::sqrt(1 - lean * lean)),
               rho = (psi + turns(x, y)) / 2;
        if (symmetry == "isotropic") psi = rho = 0;
        const double q = std::hypot(along, across);
        const double m = constants.at("g_normal"), n = constants.at("N");
        const double w = 2 * q / (k.z * m + 2 * q);
        Answer answer{};
        answer.g = std::max(0.0, k.x * number("moment", 0) + k.y * number("moment", 1) +
                                     (k.z * m + 2 * q) * value("A", w, psi));
        answer.P = n * k.z / answer.g;
        if (clamp) answer.P = std::min(1.0, answer.P);
        const double s = std::hypot(k.x, k.y), v = (w + s / (k.z + s)) / 2;
        const double kept = clamp ? std::min(1.0, answer.g / (n * k.z)) : 1;
        const double a = std::max(0.0, value("albedo", v, rho));
        answer.R1 = a * kept;
        answer.R0 = std::max(0.0, std::pow(1 - k.z, 5) * a + value("residual", v, rho)) * kept;
        return answer;
    }

    const Table& table(const std::string& quantity) const { return tables_.at(quantity); }

  private:
    static double turns(double a, double b) {
        const double sum = std::fabs(a) + std::fabs(b);
        const double t = sum > 0 ? (std::fabs(b) - std::fabs(a)) / sum : -1;
        double u = 0.5 + t * (6 - t * t) / 10;
        if (a < 0) u = 2 - u;
        return b < 0 ? 4 - u : u;
    }

    // The place of an azimuth, in quarter turns, among n rows.
    double row(double angle, int n) const {
        const std::string symmetry = manifest_.at("symmetry");
        if (symmetry == "quarter") return angle * (n - 1);
        if (symmetry == "half") return angle / 2 * (n - 1);
        if (symmetry == "none") return angle / 4 * n;
        return 0;
    }

    int next(int index, int n) const {
        return manifest_.at("symmetry") == "none" ? (index + 1) % n : std::min(index + 1, n - 1);
    }

    double value(const char* quantity, double at, double angle) const {
        const Table& t = tables_.at(quantity);
        const double column = std::min(at, 1.0) * (t.width - 1), place = row(angle, t.height);
        const int i = std::min(static_cast<int>(column), t.width - 2),
                  j = std::min(static_cast<int>(place), t.height - 1);
        const int j2 = next(j, t.height);
        return std::lerp(std::lerp(t.at(i, j), t.at(i + 1, j), column - i),
                         std::lerp(t.at(i, j2), t.at(i + 1, j2), column - i), place - j);
    }

    Json manifest_;
    std::map<std::string, Table> tables_;
};

Design none_symmetric() {
    Design design = design_of(GgxLobe{0.1, 0.4});
    design.distribution.layers[0].rotation = 20;
    Layer leaning = layer_of(GgxLobe{0.3, 0.3});
    leaning.tilt = 30;
    leaning.azimuth = 100;
    design.distribution.layers.push_back(leaning);
    return design;
}

Design half_symmetric() {
    Design design = design_of(GgxLobe{0.2, 0.5});
    design.distribution.layers[0].tilt = 40;
    design.distribution.layers[0].azimuth = 50;
    return design;
}

}  // namespace

TEST_CASE("g, P and R evaluated from the written files alone are those of `tables`") {
    const TemporaryFolder folder;
    Design quarter = design_of(GgxLobe{0.1, 0.5});
    quarter.distribution.layers[0].rotation = 30;
    for (Design model : {design_of(GgxLobe{0.2, 0.2}), quarter, half_symmetric(), none_symmetric()}) {
        model.fresnel = SchlickFresnel{};
        const DesignOnDisk design(model);
        answer({"export", design.path(), "--to", "exr", "-o", folder / "tables"});
        const Stranger stranger(folder / "tables");
        const auto directions = test_directions(500);
        const auto expected = rows(answer({"tables", design.path()}, lines_of(directions)));
        double worst_area = 0, worst_rest = 0;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const Stranger::Answer got = stranger.evaluate(directions[i]);
            const std::vector<double>& row = expected[i];
            worst_area = std::fmax(worst_area, std::fabs(got.g / row.at(0) - 1));
            for (const double error : {got.P - row.at(1), got.R0 - row.at(2), got.R1 - row.at(3)})
                worst_rest = std::fmax(worst_rest, std::fabs(error));
        }
        CHECK(worst_area < 1e-6);
        CHECK(worst_rest < 1e-6);
    }
}

TEST_CASE("the marked corners, the three colours and the pictures are where the manifest says") {
    const TemporaryFolder folder;
    auto raster = std::make_shared<Raster>(Raster{2, 2, {1, 2, 3, 4}});
    Design model = design_of(PaintedLobe{Picture{{}, raster}});
    model.fresnel = ConductorFresnel{};
    const DesignOnDisk design(model);
    answer({"bake", design.path(), "-o", folder / "tables"});
    const Stranger stranger(folder / "tables");
    const Table& corners = stranger.table("corners");
    CHECK(corners.at(0, 0) == 1);
    CHECK(corners.at(corners.width - 1, 0) == 2);
    CHECK(corners.at(0, corners.height - 1) == 3);
    CHECK(corners.at(corners.width - 1, corners.height - 1) == 4);
    CHECK(stranger.table("residual").channels == 3);
    const Table& painted = stranger.table("painted");
    CHECK(painted.at(1, 0) / painted.at(0, 1) == doctest::Approx(2.0 / 3));
}
