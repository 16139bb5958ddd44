// What each format holds of a design: the table in docs/renderers, and each of its cells.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/formats/export_format.h"
#include "core/formats/merl_file.h"
#include "tests/core/cheap.h"
#include "tests/core/designs.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// A design with this feature, cheap to bake.
Design design_with(Feature feature) {
    Design design;
    Layer& layer = design.distribution.layers.front();
    layer.lobe = GgxLobe{};
    switch (feature) {
        case Feature::specular:
            break;
        case Feature::anisotropic:
            layer.lobe = GaussianLobe{.sigma_x = 0.3, .sigma_y = 0.6};
            break;
        case Feature::painted:
            layer.modulation =
                Modulation{.image = picture_of(4, [](double x, double y) { return 1 + 0.5 * x + 0.25 * y; })};
            break;
        case Feature::leaning:
            layer.tilt = 20;
            break;
        case Feature::intensity:
            design.specular.intensity = 0.5;
            break;
        case Feature::multibounce:
            design.multibounce = RankOneMultibounce{};
            break;
        case Feature::tint:
            layer.tint = {1, 0.5, 0.25};
            break;
        case Feature::coupled:
            design.diffuse = CoupledDiffuse{};
            break;
        case Feature::diffuse:
            design.diffuse = LambertianDiffuse{};
            break;
        case Feature::facets:
            design.diffuse = FacetDiffuse{};
            break;
        case Feature::film:
            design.fresnel = FilmFresnel{};
            break;
        case Feature::coat:
            design.coat = ClearCoat{};
            break;
        case Feature::retro:
            design.retro.weight = 0.5;
            break;
        case Feature::correlated:
            design.shadowing.model = CorrelatedMasking{};
            break;
    }
    return design;
}

constexpr const char* begin_mark = "<!-- holdings, by scripts/update-format -->\n";
constexpr const char* end_mark = "<!-- end of holdings -->\n";

std::string table() {
    std::string text = "| |", line = "| --- |";
    for (const ExportFormat* format : export_formats()) {
        text += fmt::format(" `{}` |", format->name);
        line += " --- |";
    }
    text += "\n" + line + "\n";
    for (const FeatureInfo& info : all_features()) {
        text += fmt::format("| {} |", info.title);
        for (const ExportFormat* format : export_formats())
            text += fmt::format(" {} |", name_of(format->holds[info.feature]));
        text += "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("formats: a design has the features that it is given, and no others that it need not have") {
    const Design plain = design_with(Feature::specular);
    for (const FeatureInfo& info : all_features()) {
        CAPTURE(info.name);
        CHECK(has_feature(design_with(info.feature), info.feature));
        CHECK(has_feature(plain, info.feature) == (info.feature == Feature::specular));
    }
}

TEST_CASE("formats: a format refuses what its table says, and nothing else") {
    const ExportSettings settings{.bake = {.quality = Quality::draft}, .error = 1};
    for (const ExportFormat* format : export_formats())
        for (const FeatureInfo& info : all_features()) {
            CAPTURE(format->name);
            CAPTURE(info.name);
            if (cheap && info.feature != Feature::painted && info.feature != Feature::coat) continue;
            const Design design = design_with(info.feature);
            bool refused = false;
            for (const FeatureInfo& other : all_features())
                refused |=
                    format->holds[other.feature] == Holding::refused && has_feature(design, other.feature);
            CHECK(holding_of(*format, design).refused == refused);
            if (refused)
                CHECK_THROWS_AS(prepare_export(*format, design, settings, {}, {}), UserError);
            else if (format->extension != merl_format.extension ||
                     (info.feature == Feature::coat && !(cheap && format == &merl_edge_format)))
                CHECK_NOTHROW(prepare_export(*format, design, settings, {}, {}));
        }
}

TEST_CASE("formats: their JSON says options, defaults and holdings") {
    const auto list = nlohmann::json::parse(formats_json());
    REQUIRE(list.size() == export_formats().size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const ExportFormat& format = *export_formats()[i];
        CHECK(list[i].at("name") == format.name);
        CHECK(list[i].at("defaults").contains("prefix") == format.has_names);
        CHECK(list[i].at("defaults").contains("error") == format.has_error);
        CHECK(list[i].at("defaults").at("tolerance") == 1e-3);
        CHECK(list[i].at("holds").size() == feature_count);
        CHECK(list[i].at("about").get<std::string>().find('{') == std::string::npos);
    }
}

TEST_CASE("file format: the table of what formats hold is the formats' own") {
    const std::filesystem::path file = NACRE_SOURCE_DIR "/docs/renderers/README.md";
    std::string text = read_all(file);
    const std::size_t begin = text.find(begin_mark), end = text.find(end_mark);
    REQUIRE(begin != text.npos);
    REQUIRE(end != text.npos);
    const std::size_t from = begin + std::string_view(begin_mark).size();
    if (std::getenv("NACRE_UPDATE_FORMAT") != nullptr)
        write_all(file, text.replace(from, end - from, table()));
    CHECK_MESSAGE(read_all(file).substr(from, table().size()) == table(),
                  "scripts/update-format writes it anew");
}
