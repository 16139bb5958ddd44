#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/verbs.h"
#include "core/base/system/output_guard.h"
#include "core/formats/plot_files.h"

namespace nacre::cli {
namespace {

struct PlotOptions {
    std::string design;
    OutputOption output;
    std::string what = "albedo";
    std::string term = "total";
    std::string scale;
    PlotSettings settings = {};
    BakeOptions bake = {};
};

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (int i = 0; i < plot_kinds; ++i) names.emplace_back(name_of(static_cast<PlotKind>(i)));
    return names;
}

int plot(PlotOptions options, Interrupt& interrupt) {
    PlotSettings& settings = options.settings;
    settings.kind = *plot_kind(options.what);
    settings.term = *term_by_name(options.term);
    if (!options.scale.empty())
        settings.logarithmic[static_cast<std::size_t>(settings.kind)] = options.scale == "log";
    check_plot_file(options.output.named());
    const Design design = read_design(options.design);
    check_outputs(options.output.outputs(), files_of(design, options.design));
    options.bake.albedo = needs_albedo(settings);
    const auto tables = bake_design(design, options.design, options.bake, interrupt);
    const Plot made = *make_plot(*tables, settings);
    write_file_or_output(options.output.file, plot_text(options.output.named(), made), interrupt);
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<PlotOptions>();
    command.option("DESIGN", options->design, "a .nacre file; - is standard input").required();
    add_output_option(command, options->output, {"svg", "csv"}, "a .svg or .csv file");
    command.option("--what", options->what, fmt::format("{}", fmt::join(kind_names(), ", ")))
        .one_of(kind_names())
        .shows_default();
    command
        .option("--term", options->term,
                fmt::format("of lobe, lobe3d and slice: {}", fmt::join(term_names(), ", ")))
        .one_of(term_names())
        .shows_default();
    command
        .option("--theta", options->settings.incidence, "of lobe and lobe3d: the angle of k1 from the normal")
        .within(0.0, incidence_most)
        .shows_default();
    command
        .option("--phi", options->settings.azimuth,
                "the azimuth of the mirror direction (lobe, lobe3d) or of the half vector (slice)")
        .within(-360.0, 360.0)
        .shows_default();
    command.option("--phi-d", options->settings.turn, "of slice: the azimuth of the difference vector")
        .within(-360.0, 360.0)
        .shows_default();
    command.option("--scale", options->scale, "linear or log (default: log for slice, else linear)")
        .one_of({"linear", "log"});
    add_tolerance_option(command, options->bake);
    command.when_chosen([options, &action] {
        check_usage(options->output);
        action = [options](Interrupt& interrupt) { return plot(*options, interrupt); };
    });
}

}  // namespace

const Verb plot_verb{"plot", "R, P, p, F, the lobe or the slice of a design, as SVG or CSV", declare};

}  // namespace nacre::cli
