#include "core/formats/sampling_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/model/visible_facets.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr int row_count = 64, column_count = 32;  // powers of two, as sample.glsl wants them
constexpr std::size_t facet_count = std::size_t{1} << 18;

// The part of the rows' and the columns' mass that lies evenly, so that none is much wider than the others.
constexpr double even_row_share = 0.01, even_column_share = 0.1;

struct Spot {
    double t;        // 1 - h.z
    double azimuth;  // -pi to pi
};

// As n sees them, as dense as p(h) h.z; in the order of t.
std::vector<Spot> drawn_spots(const FacetDistribution& distribution) {
    const std::vector<dvec3> n(facet_count, dvec3{0, 0, 1});
    std::vector<dvec3> h(facet_count);
    Random random(1);
    distribution.visible_facets().draw(n, random, h);
    std::vector<Spot> spots;
    spots.reserve(facet_count);
    for (const dvec3& one : h)
        if (one.z > 0)
            spots.push_back({(one.x * one.x + one.y * one.y) / (1 + one.z), std::atan2(one.y, one.x)});
    std::ranges::sort(spots, {}, &Spot::t);
    return spots;
}

// Where `share` of the mass lies before; some of it evenly from `first` to `last`, the rest at the values.
double quantile(const std::vector<double>& sorted, double even, double first, double last, double share) {
    if (sorted.empty()) even = 1;
    const auto mass = [&](double at) {
        const auto before = std::ranges::lower_bound(sorted, at) - sorted.begin();
        const double part =
            sorted.empty() ? 0 : static_cast<double>(before) / static_cast<double>(sorted.size());
        return even * (at - first) / (last - first) + (1 - even) * part;
    };
    double low = first, high = last;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (mass(middle) < share ? low : high) = middle;
    }
    return high;
}

// What stands before row i: rows at both ends hold less, since the tails of a lobe are long.
double share_before(int row) {
    const double x = static_cast<double>(row) / row_count;
    const double end = std::min(x, 1 - x);
    return x < 0.5 ? 4 * end * end * end : 1 - 4 * end * end * end;
}

// Bounds from `first` to `last` that rise in float too.
void append_bounds(std::vector<double> bounds, double first, double last, std::vector<float>& values) {
    bounds.front() = first;
    bounds.back() = last;
    std::vector<float> rising(bounds.begin(), bounds.end());
    for (std::size_t i = 1; i < rising.size(); ++i)
        rising[i] = std::max(rising[i], std::nextafter(rising[i - 1], 8.0F));
    rising.back() = static_cast<float>(last);
    for (std::size_t i = rising.size() - 1; i-- > 0;)
        rising[i] = std::min(rising[i], std::nextafter(rising[i + 1], -8.0F));
    values.insert(values.end(), rising.begin(), rising.end());
}

void append_azimuths(std::vector<double> azimuths, int columns, std::vector<float>& values) {
    constexpr double pi = std::numbers::pi;
    std::ranges::sort(azimuths);
    std::vector<double> bounds(static_cast<std::size_t>(columns) + 1);
    for (int i = 1; i < columns; ++i)
        bounds[static_cast<std::size_t>(i)] =
            quantile(azimuths, even_column_share, -pi, pi, static_cast<double>(i) / columns);
    append_bounds(std::move(bounds), -pi, pi, values);
}

// The text with its lines `#if MACRO` to `#endif` and what is between them, or without: like the shared text,
// that of a design that lacks the part has not a word of it.
std::string with_part(const std::string& text, std::string_view macro, bool used) {
    const std::string opening = fmt::format("#if {}\n", macro), closing = "#endif\n";
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = text.find(opening); at != text.npos; at = text.find(opening, done)) {
        const std::size_t first = at + opening.size(), last = text.find(closing, first);
        result += text.substr(done, at - done);
        if (used) result += text.substr(first, last - first);
        done = last + closing.size();
    }
    return result + text.substr(done);
}

}  // namespace

SamplingTable sampling_table(const Tables& tables) {
    const std::vector<Spot> spots = drawn_spots(*tables.distribution);
    const bool isotropic = tables.shading.surface.tables.symmetry == Shading<double>::SYMMETRY_ISOTROPIC;
    SamplingTable table;
    table.rows = row_count;
    table.columns = isotropic ? 1 : column_count;
    table.stride = isotropic ? 0 : table.columns + 1;
    table.cosine_share = std::max(tables.shading.cosine_probability(), 0.1);
    for (int i = 0; i <= row_count; ++i) table.values.push_back(static_cast<float>(share_before(i)));
    std::vector<double> t(spots.size());
    std::ranges::transform(spots, t.begin(), &Spot::t);
    std::vector<double> bounds;
    for (int i = 0; i <= row_count; ++i) bounds.push_back(quantile(t, even_row_share, 0, 1, share_before(i)));
    append_bounds(bounds, 0, 1, table.values);
    if (isotropic) {
        append_azimuths({}, 1, table.values);
        return table;
    }
    auto begin = spots.begin();
    for (std::size_t i = 0; i < row_count; ++i) {
        const auto end = std::ranges::lower_bound(spots, bounds[i + 1], {}, &Spot::t);
        std::vector<double> azimuths;
        for (; begin < end; ++begin) azimuths.push_back(begin->azimuth);
        append_azimuths(std::move(azimuths), column_count, table.values);
    }
    return table;
}

std::string sampling_mathematics(const Tables& tables, const SamplingTable& table, std::size_t offset) {
    const ShadingKinds& kinds = tables.shading.kinds;
    std::string text;
    const auto whole = [&](const char* name, std::size_t value) {
        text += fmt::format("CONSTANT int {} = {};\n", name, value);
    };
    whole("DRAW_OFFSET", offset);
    whole("DRAW_ROWS", static_cast<std::size_t>(table.rows));
    whole("DRAW_COLUMNS", static_cast<std::size_t>(table.columns));
    whole("DRAW_STRIDE", static_cast<std::size_t>(table.stride));
    text += fmt::format("CONSTANT scalar COSINE_SHARE = scalar({:.2f});\n\n", table.cosine_share);
    std::string rest(shader_text("export/sample.glsl"));
    rest = with_part(rest, "HAS_RETRO", kinds.retro);
    rest = with_part(rest, "HAS_COAT", kinds.coated());
    return text + with_part(rest, "IS_BARE", !kinds.coated());
}

std::string sampling_calls(const std::string& prefix) {
    return fmt::format(
        "\nvec4 {0}_sample(vec3 k2, vec3 u) {{\n    vec3 k1 = {0}_drawn_direction(k2, u);\n"
        "    return vec4(k1, {0}_drawn_density(k1, k2));\n}}\n"
        "\nfloat {0}_pdf(vec3 k1, vec3 k2) {{\n    return {0}_drawn_density(k1, k2);\n}}\n",
        prefix);
}

}  // namespace nacre
