#include "app/cli/compare_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "app/cli/caption.h"
#include "app/cli/design_input.h"
#include "app/cli/progress.h"
#include "core/design/design_file.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

constexpr float label_grey = 0.92f, line_grey = 0.75f;

std::vector<std::string> opponent_names() {
    std::vector<std::string> names;
    for (const ComparisonModel& comparison_model : all_comparison_models())
        names.push_back(name_of(comparison_model));
    return names;
}

bool is_file(const std::string& name) { return fs::path(name).extension() == ".nacre"; }

std::string known_opponent(const std::string& name) {
    if (comparison_model_by_name(name) || is_file(name)) return {};
    return fmt::format("must be {}, or a .nacre file", fmt::join(opponent_names(), ", "));
}

struct Labelled {
    ComparedSurface surface;
    std::string label;
};

std::string title_of(const Design& design, const fs::path& file) {
    return one_line(design.name.empty() ? fs::path(name_of_input(file)).stem().string() : design.name);
}

Labelled bake_side(const Design& design, const std::string& file,
                   const std::optional<ComparisonModel>& comparison_model, const Scene& scene,
                   const Interrupt& interrupt) {
    Progress progress("baking");
    Baker baker;
    const BakeOptions bake{.albedo = scene.ambient};
    return {about_file(file,
                       [&] {
                           return bake_for_comparison(baker, design, comparison_model, bake,
                                                      interrupt.token(),
                                                      [&](double done) { progress.report(done); });
                       }),
            comparison_model ? label_of(*comparison_model) : title_of(design, file)};
}

// A line down the divider and each side's name at its top.
void label_sides(RenderedImage& image, double divider, const std::string& left, const std::string& right) {
    const int column = divider_column(image.size.x, divider);
    const auto width = static_cast<std::size_t>(image.size.x);
    if (column > 0 && column < image.size.x)
        for (std::size_t row = 0; row < static_cast<std::size_t>(image.size.y); ++row)
            std::fill_n(image.rgb.begin() +
                            static_cast<std::ptrdiff_t>(3 * (row * width + static_cast<std::size_t>(column))),
                        3, line_grey);
    const int height = std::clamp(image.size.y / 28, 10, 28);
    const CaptionFont font(height);
    const int top = height / 2, margin = height;
    const auto label = [&](const std::string& text, int begin, int end) {
        if (end - begin > 3 * margin)
            font.draw(image, text, 0.5 * (begin + end), top, end - begin - margin, label_grey);
    };
    label(left, 0, column);
    label(right, column, image.size.x);
}

std::string check_term(const Scene& scene, const ComparisonModel& comparison_model) {
    if (!is_factor(scene.term) || !std::holds_alternative<ClosedFormModel>(comparison_model)) return {};
    return fmt::format("--compare {}: this model has no factor {}; --term total, specular or diffuse",
                       name_of(comparison_model), info(scene.term).name);
}

RenderedImage difference_image(const RenderedPair& pair, const DifferenceLook& look, bool linear) {
    RenderedImage image{pair.left.size, {}};
    if (!linear) {
        image.rgb = difference_picture(pair.left_radiance, pair.right_radiance, 3, look);
        return image;
    }
    for (std::size_t i = 0; i < pair.left.rgb.size(); ++i)
        image.rgb.push_back(pair.right_radiance[i] - pair.left_radiance[i]);
    return image;
}

}  // namespace

void add_compare_options(Command& command, CompareOptions& options) {
    const Option compare =
        command.option("--compare", options.model,
                       fmt::format("beside it at the right, of matching width: {}; or another .nacre file",
                                   fmt::join(opponent_names(), ", ")));
    compare.check(known_opponent);
    command.option("--view", options.view, "divider or difference (default divider)")
        .one_of({"divider", "difference"})
        .needs(compare);
    command.option("--divider", options.divider, "where the divider stands, 0 to 1 (default 0.5)")
        .within(0, 1)
        .needs(compare);
    command.option("--amplify", options.look.amplification, "of the difference (default 4)")
        .within(1e-6, 1e6)
        .needs(compare);
    command
        .flag("--signed", options.look.is_signed,
              "difference: orange where the right one is brighter, blue where the left one is")
        .needs(compare);
}

std::optional<Design> design_beside(const CompareOptions& options) {
    if (options.model.empty() || comparison_model_by_name(options.model)) return {};
    return load_design(options.model);
}

ComparedImage render_comparison(const CompareOptions& options, const Design& design, const std::string& file,
                                const std::optional<Design>& beside, const Scene& scene, glm::ivec2 size,
                                bool linear, int samples, const Interrupt& interrupt) {
    const std::optional<ComparisonModel> comparison_model = comparison_model_by_name(options.model);
    if (comparison_model)
        if (const std::string problem = check_term(scene, *comparison_model); !problem.empty())
            throw std::runtime_error(problem);
    const Labelled left = bake_side(design, file, {}, scene, interrupt);
    const Labelled right = bake_side(beside.value_or(design), comparison_model ? file : options.model,
                                     comparison_model, scene, interrupt);
    RenderedPair pair = render_pair(left.surface, right.surface, scene, size, linear, samples);
    const DifferenceNumbers& apart = pair.difference;
    std::string summary =
        fmt::format("{} against {}: root mean square {:.4g}, largest {:.4g}, relative {:.4g}\n", left.label,
                    right.label, apart.root_mean_square, apart.largest, apart.relative);
    if (options.view == "difference")
        return {difference_image(pair, options.look, linear), std::move(summary)};
    RenderedImage image{size, divided_picture(pair.left.rgb, pair.right.rgb, size, 3, options.divider)};
    if (!linear) label_sides(image, options.divider, left.label, right.label);
    return {std::move(image), std::move(summary)};
}

}  // namespace nacre::cli
