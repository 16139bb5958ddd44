#include <fmt/core.h>

#include <memory>

#include "app/cli/design_input.h"
#include "app/cli/message.h"
#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/system/output_guard.h"
#include "core/fit/fit_json.h"
#include "core/fit/lobe_fit.h"

namespace nacre::cli {
namespace {

struct FitOptions {
    std::string design;
    std::string output;
    int lobes = 32;
    std::string family = "beckmann";
    std::string weights;
    std::string target = "cycles";
};

FitSettings settings_of(const FitOptions& options) {
    FitSettings settings;
    settings.lobes = options.lobes;
    settings.shape = options.family == name_of(LobeShape::ggx) ? LobeShape::ggx : LobeShape::beckmann;
    settings.target =
        options.target == name_of(FitTarget::standard) ? FitTarget::standard : FitTarget::cycles;
    if (options.weights == name_of(LobeWeights::constant)) settings.weights = LobeWeights::constant;
    if (options.weights == name_of(LobeWeights::view)) settings.weights = LobeWeights::view;
    return settings;
}

std::string summary(const LobeFit& fit) {
    const std::size_t count = fit.mixture.lobes.size();
    std::string text;
    for (const Misplaced& tried : fit.tried)
        text += fmt::format("{} {} {}, {} weights: {:.2f} % of the energy misplaced{}\n", count,
                            fit.mixture.shape == LobeShape::ggx ? "GGX" : "Beckmann",
                            count == 1 ? "lobe" : "lobes", name_of(tried.weights), 100 * tried.energy,
                            fit.tried.size() > 1 && tried.weights == fit.mixture.weights ? ", kept" : "");
    return text;
}

int fit_design(const FitOptions& options, Interrupt& interrupt) {
    const Design design = read_design(options.design);
    const bool to_stream = options.output == stream_name;
    if (!options.output.empty())
        check_outputs({to_stream ? "/dev/stdout" : options.output}, files_of(design, options.design));
    const auto tables = bake_design(design, options.design, {}, interrupt);
    const LobeFit fit = about_file(options.design, [&] {
        Progress progress("fitting");
        return fit_lobes(*tables, settings_of(options), interrupt.token(),
                         [&](double done) { progress.report(done); });
    });
    // Where the file itself is standard output the figures are in it.
    if (!to_stream) write_output(summary(fit));
    if (!options.output.empty()) write_file_or_output(options.output, fit_json(fit), interrupt);
    for (const std::string& note : fit_notes(fit, *tables)) warn(name_of_input(options.design), note);
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<FitOptions>();
    command.option("DESIGN", options->design, "a .nacre file; - is standard input").required();
    command.option("--lobes", options->lobes, "how many").shows_default().within(1, fit_lobes_max);
    command.option("--family", options->family, "the normal distribution of each")
        .shows_default()
        .one_of({"beckmann", "ggx"});
    const auto weights =
        command
            .option("--weights", options->weights,
                    "constant, or an image over the viewing direction for each lobe; best fits both and "
                    "keeps the nearer (default: best, and constant for the standard target)")
            .one_of({"constant", "view", "best"});
    command
        .option("--target", options->target,
                "whose formula: cycles has tilted lobes that mask themselves; standard has lobes about the "
                "surface normal with height-correlated masking, as glTF and OpenPBR")
        .shows_default()
        .one_of({"cycles", "standard"});
    command.option("-o,--output", options->output, "the lobes as a .json file; - is standard output")
        .check(not_empty);
    command.footer(
        "Prints how much of the energy of the specular term (F = 1) the lobes send elsewhere than the\n"
        "design, from 0 to 200 %: docs/fit.md has the model and what to expect.");
    command.when_chosen([=, &action] {
        if (options->target == name_of(FitTarget::standard) && weights.given() &&
            options->weights != name_of(LobeWeights::constant))
            throw_wrong_usage("--weights: the target standard has constant weights only");
        action = [options](Interrupt& interrupt) { return fit_design(*options, interrupt); };
    });
}

}  // namespace

const Verb fit_verb{"fit", "a few Beckmann or GGX lobes for renderers that have no tables", declare};

}  // namespace nacre::cli
