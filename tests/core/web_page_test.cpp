// The exported web page as text: what it holds, how large it is, and what its 16-bit floats change.
#include "core/formats/web_page.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "core/bake/bake.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_sampler.h"
#include "core/formats/web_light.h"
#include "core/formats/web_shader.h"
#include "core/light/facet_order.h"
#include "tests/core/cheap.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

std::string between(const std::string& text, std::string_view begin, std::string_view end) {
    const std::size_t at = text.find(begin) + begin.size();
    return text.substr(at, text.find(end, at) - at);
}

nlohmann::json data_of(const std::string& html) {
    return nlohmann::json::parse(
        between(html, "<script type=\"application/json\" id=\"data\">", "</script>"));
}

// Base 64, then zlib's stream of `size` bytes.
std::string unpacked(const std::string& text, std::size_t size) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string packed;
    unsigned bits = 0, count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<unsigned>(digits.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        packed += static_cast<char>(static_cast<unsigned char>(bits >> count & 255u));
    }
    std::string bytes(size + 1, '\0');
    uLongf length = bytes.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
    bytes.resize(length);
    REQUIRE(bytes.size() == size);
    return bytes;
}

Design plain_design() {
    Design design = design_of(GgxLobe{0.2, 0.4});
    design.name = "Plain";
    design.diffuse = CoupledDiffuse{};
    return design;
}

std::shared_ptr<const Tables> draft(const Design& design) {
    return bake(design, {.quality = Quality::draft, .albedo = true});
}

// Noise that no deflating makes smaller.
Design noisy_design(int side) {
    Random random(3);
    PaintedLobe lobe;
    lobe.image = picture_of(side, [&](double, double) { return 0.1 + 0.9 * uniform_random(random); });
    return design_of(lobe);
}

}  // namespace

TEST_SUITE_BEGIN("web page");

TEST_CASE("name and note are text, whatever they hold") {
    Design design = plain_design();
    design.name = "</title></script><b onclick=\"x\">&{{css}}";
    design.note = "first <img src=x>\nsecond {{js}} & last";
    const std::string html = web_page(design, *draft(design));
    CHECK(
        has(html, "<title>&lt;/title&gt;&lt;/script&gt;&lt;b onclick=&quot;x&quot;&gt;&amp;{{css}}</title>"));
    CHECK(has(html, "first &lt;img src=x&gt;<br>\nsecond {{js}} &amp; last</p>"));
    CHECK_FALSE(has(html, "<b "));
    CHECK_FALSE(has(html, "<img"));
    CHECK(data_of(html)["rows"] == 1);
    design.name.clear();
    CHECK(has(web_page(design, *draft(design)), "<title>Untitled</title>"));
}

TEST_CASE("it asks for nothing from elsewhere, and forbids it") {
    const Design design = plain_design();
    const std::string html = web_page(design, *draft(design));
    for (const char* part : {"http:", "https:", " src=", " href=", "@import", "url(", "{{", "@part", "@with"})
        CHECK_MESSAGE(!has(html, part), part);
    CHECK(has(html, "content=\"default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'\""));
}

TEST_CASE("ambient light is offered where the tables hold R") {
    Design design = design_of(GgxLobe{0.2, 0.4});
    for (const bool albedo : {false, true}) {
        const auto tables = bake(design, {.quality = Quality::draft, .albedo = albedo});
        CHECK(data_of(web_page(design, *tables))["albedo"] == albedo);
    }
}

TEST_CASE("tables are 16-bit floats where that changes less than 1/500 of the light, else 32-bit ones") {
    const Design smooth = plain_design();
    const auto tables = draft(smooth);
    const WebPage page = make_web_page(smooth, *tables);
    CHECK(page.half);
    CHECK(page.rounded > 0);
    CHECK(page.rounded <= 2e-3);
    const auto data = data_of(page.html);
    const std::size_t texels = static_cast<std::size_t>(texture_rows(tables->data.size())) * 1024;
    const std::string bytes = unpacked(data["tables"], 2 * texels);
    for (std::size_t i = 0; i < tables->data.size(); ++i) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, bytes.data() + 2 * i, 2);
        const double value = static_cast<double>(tables->data[i]);
        CHECK(std::fabs(static_cast<double>(glm::unpackHalf1x16(bits)) - value) <=
              std::fabs(value) / 2048 + 0x1p-25);
    }

    // Light that bounces multiplies what is left of 1 by hundreds.
    const Design metal = load_design(NACRE_SOURCE_DIR "/presets/copper.nacre");
    const auto exact = bake(metal, {.albedo = true});
    const WebPage other = make_web_page(metal, *exact);
    CHECK_FALSE(other.half);
    CHECK(rounding_error(*exact, rounded_data(*exact, Rounded::everything)) > 2e-3);
    CHECK(other.rounded == 0);
    CHECK(unpacked(data_of(other.html)["tables"], texture_bytes(exact->data).size()) ==
          texture_bytes(exact->data));
}

TEST_CASE(
    "the error of other numbers is 0 for the same ones, and sees those that are too large for 16 bits") {
    const auto tables = draft(plain_design());
    CHECK(rounding_error(*tables, tables->data) == 0);
    CHECK(rounding_error(*tables, rounded_data(*tables, Rounded::nothing)) == 0);
    auto wrong = tables->data;
    for (float& value : wrong) value *= 1.01f;
    CHECK(rounding_error(*tables, wrong) > 5e-3);
    wrong.front() = static_cast<float>(limits::infinity);
    CHECK(rounding_error(*tables, wrong) == limits::infinity);
}

TEST_CASE("a layer of 512 x 512 texels fits into 1.5 MiB as it is, also where its tables are 32-bit floats" *
          doctest::skip(cheap)) {
    const Design plain = noisy_design(512);
    Design metal = plain;
    metal.fresnel = ConductorFresnel{};
    metal.multibounce = MomentumMultibounce{};
    for (const Design& design : {plain, metal}) {
        const auto tables = design == plain ? draft(design) : bake(design, {.albedo = true});
        REQUIRE(tables->data.size() > 512 * 512);
        const WebPage page = make_web_page(design, *tables);
        MESSAGE(page.html.size() << " bytes, half: " << page.half << ", rounded: " << page.rounded);
        CHECK(page.html.size() <= web_page_max);
        CHECK(page.html.size() > web_page_max / 2);
        CHECK(page.rounded <= 2e-3);
        CHECK(page.remark == "");
    }
}

TEST_CASE("larger pictures are made smaller, and the page says what that changes") {
    const Design design = noisy_design(1024);
    const WebPage page = make_web_page(design, *draft(design));
    CHECK(page.html.size() <= web_page_max);
    CHECK(page.remark.starts_with("Pictures of up to 1024 pixels a side are shown with "));
    CHECK(has(page.html, page.remark));
    CHECK(data_of(page.html)["rows"] < 1024);
}

TEST_CASE("the change of p is of its largest value") {
    PaintedLobe fine;
    fine.image = picture_of(
        64, [](double x, double) { return std::fmod(std::floor((x + 1) * 32), 2) > 0 ? 2.0 : 1.0; });
    PaintedLobe flat;
    flat.image = picture_of(64, [](double, double) { return 1.5; });
    const auto before = draft(design_of(fine)), after = draft(design_of(flat));
    CHECK(density_change(*before->distribution, *before->distribution).worst == 0);
    const DensityChange change = density_change(*before->distribution, *after->distribution);
    CHECK(change.worst == doctest::Approx(0.25).epsilon(0.02));
    CHECK(change.mean > 0.08);
    CHECK(change.mean < 0.25);
}

TEST_CASE("an order keeps its ranges and as many directions of each") {
    const auto tables = draft(plain_design());
    const DirectionOrder order = order_facets(*tables->distribution, 64);
    const std::string bytes = order_bytes(order);
    CHECK(bytes.size() % (256 * 8) == 0);
    CHECK(bytes.size() >= static_cast<std::size_t>(order_nodes + order_leaves * web_leaf_size) * 8);
    const auto texel = [&](int index) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, bytes.data() + 8 * index, 8);
        return glm::unpackHalf4x16(bits);
    };
    for (int i = 0; i < order_nodes; i += 7)
        CHECK(glm::distance(texel(i), order.texels[static_cast<std::size_t>(i)]) < 1e-3f);
    constexpr int step = order_leaf_size / web_leaf_size;
    for (int i = 0; i < order_leaves * web_leaf_size; i += 13) {
        const auto kept = static_cast<std::size_t>(order_nodes + i * step + step / 2);
        CHECK(glm::distance(texel(order_nodes + i), order.texels[kept]) < 1e-3f);
    }
}

TEST_CASE("a shader that lacks what the page takes the place of is a defect that shows") {
    CHECK(with_text("a b a", "a", "c") == "c b c");
    CHECK_THROWS_AS(with_text("a b a", "d", "c"), std::logic_error);
}

TEST_SUITE_END();
