#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/error.h"
#include "core/study/accuracy_chart.h"
#include "core/study/accuracy_text.h"

namespace nacre {
namespace {

std::string escaped(const std::string& text, std::string_view special) {
    std::string safe;
    for (const char c : text) {
        if (special.find(c) != special.npos) safe += '\\';
        safe += c;
    }
    return safe;
}

// Plain text in a table's cell or a heading.
std::string cell(const std::string& text) { return escaped(one_line(text), "\\|`*_<>[]&#~$!"); }

// A file's name as the target of a link, between < and >.
std::string markdown_target(const std::string& file) { return escaped(file, "\\<>"); }

std::string time_text(double seconds) {
    if (seconds < 1e-3) return fmt::format("{:.3g} µs", 1e6 * seconds);
    if (seconds < 1) return fmt::format("{:.3g} ms", 1e3 * seconds);
    return fmt::format("{:.3g} s", seconds);
}

std::string error_text(double error) { return fmt::format("{:.1e}", error); }

std::string design_name(const DesignAccuracy& design) {
    return cell(design.name.empty() ? design.file : design.name);
}

std::vector<ShownPoint> points_of(const DesignAccuracy& design, MethodKind kind, ChartOf quantity) {
    for (const MethodAccuracy& method : design.methods)
        if (method.kind == kind) return shown_points(method, quantity);
    return {};
}

std::string point_text(const std::optional<ShownPoint>& point) {
    if (!point) return "-";
    return fmt::format("{} in {}", error_text(point->error.worst), time_text(point->seconds));
}

// The cheapest that is about as good as the best.
std::optional<ShownPoint> best_of(const std::vector<ShownPoint>& points) {
    if (points.empty()) return std::nullopt;
    double least = points.front().error.worst;
    for (const ShownPoint& point : points) least = std::min(least, point.error.worst);
    return *std::find_if(points.begin(), points.end(),
                         [&](const ShownPoint& point) { return point.error.worst <= 1.05 * least; });
}

std::optional<ShownPoint> last_of(const std::vector<ShownPoint>& points) {
    return points.empty() ? std::nullopt : std::optional(points.back());
}

std::string ratio_text(double ratio) {
    return fmt::format("{:.{}f}", ratio, ratio < 0.95 ? 2 : ratio < 9.5 ? 1 : 0);
}

// The cost of a plain grid as good as `goal` over that of `goal`. Each grid has four times the nodes of the
// one before: between the last that is worse and the first that is not cost follows error by a power law.
std::string as_good(const std::vector<ShownPoint>& plain, const std::optional<ShownPoint>& goal) {
    if (!goal) return "-";
    const double error = goal->error.worst;
    const auto good = std::find_if(plain.begin(), plain.end(),
                                   [error](const ShownPoint& point) { return point.error.worst <= error; });
    if (good == plain.end()) return "none of those measured";
    const ShownPoint& last_worse = good == plain.begin() ? *good : *std::prev(good);
    const double part =
        last_worse.error.worst > error && good->error.worst > 0
            ? std::log(last_worse.error.worst / error) / std::log(last_worse.error.worst / good->error.worst)
            : 1;
    const auto between = [part](double a, double b) { return a * std::pow(b / a, part); };
    return fmt::format(
        "{} x bytes, {} x time",
        ratio_text(between(static_cast<double>(last_worse.bytes), static_cast<double>(good->bytes)) /
                   static_cast<double>(goal->bytes)),
        ratio_text(between(last_worse.seconds, good->seconds) / goal->seconds));
}

std::string summary_row(const DesignAccuracy& design, ChartOf quantity) {
    std::optional<ShownPoint> draft, final;
    for (const ShownPoint& point : points_of(design, MethodKind::bake, quantity))
        (point.setting == "draft" ? draft : final) = point;
    return fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n", design_name(design), name_of(design.symmetry),
        point_text(last_of(points_of(design, MethodKind::monte_carlo, quantity))),
        point_text(best_of(points_of(design, MethodKind::cubature, quantity))), point_text(draft),
        point_text(final), as_good(points_of(design, MethodKind::plain_grid, quantity), final));
}

std::string summary(const std::vector<DesignAccuracy>& designs, ChartOf quantity) {
    std::string text =
        "| design | symmetry | 200 points, Monte Carlo | 200 points, cubature | draft bake | final bake | "
        "plain grid "
        "as good as the final bake |\n| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const DesignAccuracy& design : designs) text += summary_row(design, quantity);
    return text;
}

std::string cost_text(const BakeCost& cost) {
    return fmt::format("{} | {}", time_text(cost.seconds), cost.bytes);
}

std::string cost_summary(const std::vector<DesignAccuracy>& designs) {
    std::string text =
        "| design | bake | bytes | with all put back: bake | bytes |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const DesignAccuracy& design : designs)
        text += fmt::format("| {} | {} | {} |\n", design_name(design), cost_text(design.costs.bake),
                            cost_text(design.costs.with_all));
    return text;
}

std::string harmonics_summary(const std::vector<DesignAccuracy>& designs) {
    std::string text = "| design | g by spherical harmonics |\n| --- | --- |\n";
    for (const DesignAccuracy& design : designs)
        for (const MethodAccuracy& method : design.methods) {
            if (method.kind != MethodKind::harmonics) continue;
            const auto best = best_of(shown_points(method, ChartOf::area));
            text += fmt::format(
                "| {} | {} |\n", design_name(design),
                best ? fmt::format("{}: worst error {}", best->setting, error_text(best->error.worst))
                     : "left out: " + method.left_out);
        }
    return text;
}

std::string method_tables(const DesignAccuracy& design) {
    std::string text =
        "| method | setting | of | time | bytes | worst | root mean square |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const MethodAccuracy& method : design.methods) {
        for (const AccuracyPoint& point : method.points)
            text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", method.name, point.setting,
                                name_of(point.quantity), time_text(point.seconds), point.bytes,
                                error_text(point.error.worst), error_text(point.error.root_mean_square));
        if (!method.left_out.empty())
            text += fmt::format("| {} | left out: {} | | | | | |\n", method.name, method.left_out);
    }
    return text;
}

std::string cost_table(const OmissionCosts& costs) {
    std::string text = fmt::format(
        "| | bake | bytes | because |\n| --- | --- | --- | --- |\n| as the design asks | "
        "{} | |\n",
        cost_text(costs.bake));
    for (const OmissionCost& cost : costs.omissions)
        text += fmt::format("| with {} | {} | {} |\n", cost.omission.what, cost_text(cost.with_it),
                            cell(cost.omission.why));
    text += fmt::format("| with all of these | {} | |\n", cost_text(costs.with_all));
    return text;
}

std::string design_section(const DesignAccuracy& design) {
    return fmt::format(
        "\n## {}\n\n{}![g](<{}>)\n\n![R](<{}>)\n\n{}\nWhat is left out, and what it would cost to have "
        "it:\n\n{}",
        design_name(design), design.energy_note.empty() ? "" : fmt::format("The {}.\n\n", design.energy_note),
        markdown_target(chart_file(design.file, ChartOf::area)),
        markdown_target(chart_file(design.file, ChartOf::albedo)), method_tables(design),
        cost_table(design.costs));
}

std::string about_methods(const std::vector<DesignAccuracy>& designs) {
    std::string text;
    if (designs.empty()) return text;
    for (const MethodAccuracy& method : designs.front().methods)
        text += fmt::format("- **{}**: {}.\n", method.name, method.about);
    return text;
}

}  // namespace

std::string accuracy_markdown(const std::vector<DesignAccuracy>& designs) {
    std::string text = "# Error beside time\n\n";
    text += about_methods(designs);
    text += fmt::format(
        "\nThe error of g is relative, that of R (with F = 1 and with Schlick's factor of f0 = 0) absolute, "
        "both the "
        "worst of a fixed set of directions that reaches from the normal to grazing. Times are the "
        "processor's, from the "
        "design to the "
        "table, with one thread; that of R holds that of g.\n\n## Summary\n\nWorst error of g:\n\n{}\nWorst "
        "error of R:\n\n{}\nA second opinion "
        "on g:\n\n{}"
        "\nWhat the bake leaves out:\n\n{}",
        summary(designs, ChartOf::area), summary(designs, ChartOf::albedo), harmonics_summary(designs),
        cost_summary(designs));
    for (const DesignAccuracy& design : designs) text += design_section(design);
    return text;
}

}  // namespace nacre
