#include <fmt/core.h>

#include <chrono>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/system/output_guard.h"
#include "core/formats/export_format.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
    std::string design;
    std::string format;
    std::string output;
    bool list = false;
    bool json = false;
    bool verbose = false;
    ExportSettings settings = {};
};

std::string list_of_formats(const std::string& prefix) {
    std::string text;
    for (const ExportFormat* format : export_formats())
        text += fmt::format("{:<9} {}\n", format->name, about(*format, prefix));
    return text;
}

std::vector<std::string> format_names() {
    std::vector<std::string> names;
    for (const ExportFormat* format : export_formats()) names.emplace_back(format->name);
    return names;
}

// For whoever reads along: a script that takes standard error sees it only by its own wish.
void tell_next(const ExportFormat& format, const ExportOptions& options, const std::vector<fs::path>& files) {
    if (!options.verbose && !error_is_terminal()) return;
    std::string text;
    for (const fs::path& file : files) text += fmt::format("wrote {}\n", one_line(file.string()));
    int number = 0;
    for (const std::string& step : next_steps(format, options.settings.prefix, options.output))
        text += fmt::format("{}. {}\n", ++number, step);
    write_message(text, std::chrono::seconds(1));
}

int export_design(const ExportOptions& options, Interrupt& interrupt) {
    if (options.list) {
        write_output(options.json ? formats_json() : list_of_formats(options.settings.prefix));
        return 0;
    }
    const ExportFormat* format = export_format(options.format);
    const Design design = read_design(options.design);
    const bool to_stream = options.output == stream_name;
    check_outputs(to_stream ? std::vector<fs::path>{"/dev/stdout"} : format->files(design, options.output),
                  files_of(design, options.design));
    const ExportWriter write = about_file(options.design, [&] {
        Progress progress("baking");
        return prepare_export(*format, design, options.settings, interrupt.token(),
                              [&](double done) { progress.report(done); });
    });
    if (to_stream) {
        if (!write.is_one_file())
            throw UserError("", "-o -", fmt::format("the format {} is more than one file", format->name));
        write_output(write.bytes());
    } else {
        std::vector<fs::path> written;
        interrupt.write_files([&] { written = write(options.output); });
        tell_next(*format, options, written);
    }
    std::string notes;
    for (const std::string& note : write.notes) notes += note + "\n";
    if (!notes.empty()) write_message(notes, std::chrono::seconds(1));
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<ExportOptions>();
    const auto list = command.flag("--list", options->list, "the formats there are");
    command
        .flag("--json", options->json, "with --list: as JSON, with each format's options and what it holds")
        .needs(list);
    const auto design = command.option("DESIGN", options->design, "a .nacre file; - is standard input");
    const auto format = command.option("--to", options->format, "a format of --list").one_of(format_names());
    const auto output = command.option("-o,--output", options->output,
                                       "the file or folder to write; - is standard output, for a file");
    output.check(not_empty);
    add_tolerance_option(command, options->settings.bake);
    command.flag("--verbose", options->verbose,
                 "tell on standard error what was written and what to do next with it, also where that is no "
                 "terminal");
    const auto prefix =
        command
            .option("--prefix", options->settings.prefix,
                    "what the names in the file begin with, where a format has names, so that "
                    "several designs fit into one shader")
            .shows_default()
            .check(prefix_problem);
    const auto error = command
                           .option("--error", options->settings.error,
                                   "the part of the light that may leave another way than the design sends "
                                   "it, where a format's size "
                                   "follows it: as far as the largest size of the format goes")
                           .shows_default()
                           .within(1e-4, 1);
    command.when_chosen([=, &action] {
        if (!list.given())
            for (const Option needed : {design, format, output}) needed.demand();
        const ExportFormat* chosen = export_format(options->format);
        if (options->output == stream_name && chosen != nullptr && chosen->extension.empty())
            throw_wrong_usage("-o -: " + options->format + " is a folder of files");
        if (prefix.given() && chosen && !chosen->has_names)
            throw_wrong_usage(fmt::format("--prefix: the format {} has no names", chosen->name));
        if (error.given() && chosen && !chosen->has_error)
            throw_wrong_usage(fmt::format("--error: the size of {} does not follow it", chosen->name));
        action = [options](Interrupt& interrupt) { return export_design(*options, interrupt); };
    });
}

}  // namespace

const Verb export_verb{"export", "a design in another program's format", declare};

}  // namespace nacre::cli
