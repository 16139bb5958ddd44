#include "core/formats/web_page.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/bake/bake.h"
#include "core/base/error.h"
#include "core/base/xml_text.h"
#include "core/design/design_pictures.h"
#include "core/formats/glsl_sampler.h"
#include "core/formats/web_fill.h"
#include "core/formats/web_light.h"
#include "core/formats/web_shader.h"
#include "core/formats/web_text.h"
#include "core/image/area_average.h"
#include "core/light/facet_order.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;

constexpr int facet_cells = 512;             // a hemisphere each way, of which its facets are drawn
constexpr double rounding_error_max = 2e-3;  // a fifth of a step of 8 bits on the screen
constexpr int pairs = 4096;                  // of directions, for that error
constexpr int facets = 20000;                // where two p are compared
constexpr int least_side = 16;               // of a picture that is made smaller

// Two numbers in [0, 1), the point `i` of Roberts' sequence (2018).
dvec2 spread_point(int i) {
    const double x = (i + 0.5) * 0.7548776662466927, y = (i + 0.5) * 0.5698402909980532;
    return {x - std::floor(x), y - std::floor(y)};
}

dvec3 upper_direction(dvec2 at) {
    const double sine = std::sqrt(1 - at.x * at.x), phi = 2 * std::numbers::pi * at.y;
    return {sine * std::cos(phi), sine * std::sin(phi), at.x};
}

// Numbers in rows of 1024, as 16-bit floats or as 32-bit ones.
std::string number_bytes(const std::vector<float>& data, bool half) {
    std::string bytes;
    for (const float value : data)
        half ? add_half(bytes, static_cast<double>(value)) : add_float(bytes, value);
    const std::size_t row = half ? 2048 : 4096;
    bytes.resize((bytes.size() + row - 1) / row * row);
    return bytes;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
              static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
    packed.resize(size);
    return packed;
}

// Lines of the note stay lines.
std::string html_lines(const std::string& text) {
    std::string html;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        html += (begin > 0 ? "<br>\n" : "") + xml_text(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return html;
}

std::string packed(const std::string& bytes) { return base64(deflated(bytes)); }

Json page_environments() {
    Json all = Json::array();
    for (const auto& environment : web_environments())
        all.push_back({{"name", environment->name},
                       {"brightness", environment->brightness},
                       {"width", environment->picture.width},
                       {"height", environment->picture.height},
                       {"picture", packed(picture_bytes(*environment))},
                       {"order", packed(order_bytes(environment->light))}});
    return all;
}

std::string page_data(const Tables& tables, const std::vector<float>& numbers, bool half) {
    const std::string light = with_text(web_fragment_shader(tables.shading, "light.frag"),
                                        fmt::format("ORDER_LEAF_SIZE = {}", order_leaf_size),
                                        fmt::format("ORDER_LEAF_SIZE = {}", web_leaf_size));
    const Json data = {{"half", half},
                       {"rows", texture_rows(tables.data.size())},
                       {"albedo", tables.needs.albedo},
                       {"vertex", web_vertex_shader()},
                       {"fragment", web_fragment_shader(tables.shading, "page.frag")},
                       {"light", light},
                       {"tables", packed(number_bytes(numbers, half))},
                       {"facets", packed(order_bytes(order_facets(*tables.distribution, facet_cells)))},
                       {"environments", page_environments()}};
    std::string text = data.dump();
    // So that nothing in it looks like the end of the element.
    for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
    return text;
}

WebPage page_of(const Design& design, const Tables& tables, const std::string& remark) {
    WebPage page;
    page.remark = remark;
    std::vector<float> numbers;
    for (const Rounded what : {Rounded::everything, Rounded::pictures, Rounded::nothing}) {
        numbers = rounded_data(tables, what);
        page.half = what == Rounded::everything;
        page.rounded = rounding_error(tables, numbers);
        if (page.rounded <= rounding_error_max) break;
    }
    const std::string name = design.name.empty() ? "Untitled" : design.name;
    page.html =
        filled(web_text("page.html"),
               {{"name", xml_text(name)},
                {"note", html_lines(design.note)},
                {"remark", remark.empty() ? "" : "<p class=\"remark\">" + xml_text(remark) + "</p>\n"},
                {"css", std::string(web_text("page.css"))},
                {"js", std::string(web_text("picture.js")) + "\n" + std::string(web_text("page.js"))},
                {"data", page_data(tables, numbers, page.half)}});
    return page;
}

int largest_side(const Design& design) {
    int side = 0;
    for_each_picture(design, [&](const Picture& picture, const std::string&) {
        side = std::max(side, picture.raster->width);
    });
    return side;
}

Design with_smaller_pictures(Design design, int side) {
    for_each_picture(design, [&](Picture& picture, const std::string&) {
        if (picture.raster->width <= side) return;
        picture.raster = std::make_shared<const Raster>(area_average(*picture.raster, side));
        picture.file.clear();
    });
    return design;
}

std::string percent(double part) { return fmt::format("{:.2g} %", 100 * part); }

}  // namespace

std::vector<float> rounded_data(const Tables& tables, Rounded what) {
    std::vector<float> data(tables.data);
    const auto round = [&](int first, int count) {
        for (int i = first; i < first + count; ++i) {
            float& value = data[static_cast<std::size_t>(i)];
            value = glm::unpackHalf1x16(glm::packHalf1x16(value));
        }
    };
    if (what == Rounded::everything) round(0, static_cast<int>(data.size()));
    const Shading<double>& shading = tables.shading;
    for (int i = 0; what == Rounded::pictures && i < shading.layer_count; ++i) {
        const auto& layer = shading.layers[i];
        if (lobe_reads_picture(layer.kind)) round(layer.data_offset, layer.data_size * layer.data_size);
        round(layer.picture_offset, layer.picture_size * layer.picture_size);
    }
    return data;
}

double rounding_error(const Tables& tables, const std::vector<float>& data) {
    if (!std::ranges::all_of(data, [](float value) { return std::isfinite(value); })) return limits::infinity;
    const Shading<double>& exact = tables.shading;
    Shading<double> half = exact;
    half.data = data.data();
    if (exact.kinds.fresnel_is_curve())
        half.curve = data.data() + static_cast<std::ptrdiff_t>(exact.surface.fresnel_a.x);
    Random random(5);
    double worst = 0;
    for (int i = 0; i < pairs; ++i) {
        const dvec3 k1 = upper_direction(spread_point(i));
        dvec3 k2 = upper_direction(spread_point(pairs + 7 * i));
        // Half of them lie where p is.
        if (i % 2 && exact.projected_area(k1, exact.table_spot(k1)) > 0) {
            const dvec3 h = tables.distribution->sample_visible(k1, random);
            k2 = 2 * glm::dot(k1, h) * h - k1;
        }
        if (!(k2.z > 1e-3) || !(k1.z > 1e-3)) continue;
        const dvec3 light = exact.brdf(k1, k2) * (lamp_irradiance * k1.z);
        const dvec3 change = half.brdf(k1, k2) * (lamp_irradiance * k1.z) - light;
        for (int c = 0; c < 3; ++c)
            worst = worse_error(worst, std::fabs(change[c]) / std::max(light[c], least_radiance));
    }
    return worst;
}

DensityChange density_change(const FacetDistribution& before, const FacetDistribution& after) {
    DensityChange change;
    double largest = 0;
    for (int i = 0; i < facets; ++i) {
        const dvec3 h = upper_direction(spread_point(i));
        const double p = before.density(h), difference = std::fabs(after.density(h) - p);
        largest = std::max(largest, p);
        change.worst = std::max(change.worst, difference);
        change.mean += difference / facets;
    }
    if (largest > 0) change = {change.worst / largest, change.mean / largest};
    return change;
}

WebPage make_web_page(const Design& design, const Tables& tables) {
    WebPage page = page_of(design, tables, "");
    const int whole = largest_side(design);
    for (int side = whole * 3 / 4; page.html.size() > web_page_max; side = side * 3 / 4) {
        if (side < least_side)
            throw UserError("", "web page",
                            fmt::format("its tables do not fit into {:.1f} MiB", web_page_max / 1048576.0));
        const Design smaller = with_smaller_pictures(design, side);
        const auto baked =
            bake(smaller,
                 {.quality = tables.quality, .albedo = tables.needs.albedo, .tolerance = tables.tolerance});
        const DensityChange change = density_change(*tables.distribution, *baked->distribution);
        page = page_of(
            smaller, *baked,
            fmt::format("Pictures of up to {0} pixels a side are shown with {1}: the density of facets "
                        "changes by {2} of its largest value at most, {3} in the mean.",
                        whole, side, percent(change.worst), percent(change.mean)));
    }
    return page;
}

std::string web_page(const Design& design, const Tables& tables) {
    return make_web_page(design, tables).html;
}

}  // namespace nacre
