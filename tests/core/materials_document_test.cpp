// docs/materials.md has every measured material with its colour, beside what others have published.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "core/image/srgb.h"
#include "core/model/fresnel/measured.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr const char* begin_mark = "<!-- materials, by scripts/update-format -->\n";
constexpr const char* end_mark = "<!-- end of materials -->\n";

// sRGB, 8 bits: Adobe, Substance 3D, Metal material references, base colour (F0).
const std::map<std::string_view, glm::ivec3> published = {
    {"silver", {254, 253, 251}},    {"aluminium", {245, 246, 246}}, {"gold", {255, 219, 152}},
    {"chromium", {196, 197, 196}},  {"copper", {255, 211, 192}},    {"iron", {243, 241, 233}},
    {"mercury", {229, 228, 228}},   {"nickel", {218, 209, 197}},    {"magnesium", {242, 241, 243}},
    {"palladium", {223, 218, 212}}, {"platinum", {250, 247, 234}},  {"titanium", {178, 169, 162}},
    {"zinc", {241, 240, 238}}};

int byte_of(double linear) { return static_cast<int>(std::lround(255 * srgb_encoded(linear))); }

std::string materials_text() {
    std::string text =
        "\n| `material` | | linear Rec. 709, straight on | sRGB | sRGB, Adobe | entry | measured by |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (std::size_t i = 0; i < material_names.size(); ++i) {
        const MeasuredFresnel material{static_cast<Material>(i)};
        const glm::dvec3 colour = material.reflectance()(1), seen = MeasuredFresnel::material_colour(i);
        const auto other = published.find(material_names[i]);
        const std::string theirs = other == published.end() ? ""
                                                            : fmt::format("{}, {}, {}", other->second.x,
                                                                          other->second.y, other->second.z);
        text += fmt::format("| `{}` | {} | {:.3f}, {:.3f}, {:.3f} | {}, {}, {} | {} | {} | {} |\n",
                            material_names[i], material_labels[i], colour.x, colour.y, colour.z,
                            byte_of(seen.x), byte_of(seen.y), byte_of(seen.z), theirs,
                            material_data(material.material).entry, material_data(material.material).source);
    }
    return text + "\n";
}

}  // namespace

TEST_CASE("file format: the document of materials has every one with its colour and source") {
    const std::string materials = materials_text();
    const std::filesystem::path file = NACRE_SOURCE_DIR "/docs/materials.md";
    std::string text = read_all(file);
    const std::size_t begin = text.find(begin_mark), end = text.find(end_mark);
    REQUIRE(begin != text.npos);
    REQUIRE(end != text.npos);
    const std::size_t from = begin + std::string_view(begin_mark).size();
    if (std::getenv("NACRE_UPDATE_FORMAT") != nullptr)
        write_all(file, text.replace(from, end - from, materials));
    CHECK_MESSAGE(read_all(file).substr(from, materials.size()) == materials,
                  "scripts/update-format writes the table of docs/materials.md anew");
}
