#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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
    for (const PlotKind kind : plot_kinds) names.emplace_back(name_of(kind));
    return names;
}

// "of lobe and slice": the kinds of which something holds.
template <class Holds>
std::string of_kinds(const Holds& holds) {
    std::vector<std::string> names;
    for (const PlotKind kind : plot_kinds)
        if (holds(info(kind))) names.emplace_back(name_of(kind));
    std::string text = "of " + names.front();
    for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

std::string of_kinds_with(double PlotSettings::*angle) {
    return of_kinds([angle](const PlotInfo& kind) {
        return std::any_of(kind.angles.begin(), kind.angles.end(),
                           [angle](const PlotAngle& one) { return one.member == angle; });
    });
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
                fmt::format("{}: {}", of_kinds([](const PlotInfo& kind) { return kind.has_term; }),
                            fmt::join(term_names(), ", ")))
        .one_of(term_names())
        .shows_default();
    command
        .option("--theta", options->settings.incidence,
                of_kinds_with(&PlotSettings::incidence) + ": the angle of k1 from the normal")
        .within(0.0, incidence_max)
        .shows_default();
    command
        .option("--phi", options->settings.azimuth,
                of_kinds_with(&PlotSettings::azimuth) +
                    ": the azimuth of the mirror direction, or of the half vector for a slice")
        .within(-360.0, 360.0)
        .shows_default();
    command
        .option("--phi-d", options->settings.turn,
                of_kinds_with(&PlotSettings::turn) + ": the azimuth of the difference vector")
        .within(-360.0, 360.0)
        .shows_default();
    command
        .option("--scale", options->scale,
                fmt::format("linear or log (log is the default {}, else linear)",
                            of_kinds([](const PlotInfo& kind) { return kind.logarithmic; })))
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
