#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/table_output.h"
#include "app/cli/verbs.h"
#include "core/design/design_file.h"
#include "core/exchange/atomic_file.h"
#include "core/exchange/glsl_export.h"

namespace nacre::cli {
namespace {

struct ExportOptions {
    std::string design;
    std::string format;
    std::string output;
    bool list = false;
    BakeOptions bake = {};
};

struct Format {
    const char* name;
    const char* about;
    void (*write)(const ExportOptions& options, Interrupt& interrupt);
};

void write_exr_tables(const ExportOptions& options, Interrupt& interrupt) {
    write_tables(options.design, options.output, options.bake, interrupt);
}

void write_glsl(const ExportOptions& options, Interrupt& interrupt) {
    const Design design = load_design(options.design);
    const auto tables = bake_design(design, options.design, options.bake, interrupt);
    const std::string text = about_file(options.design, [&] { return glsl_export(design, *tables); });
    interrupt.write_files([&] { write_file_atomically(options.output, text); });
}

constexpr Format formats[] = {
    {"exr", "a folder of tables as EXR pictures, with manifest.json", write_exr_tables},
    {"glsl", "one file with the function nacre_brdf(k1, k2) and its tables as constants", write_glsl},
};

std::string list_of_formats() {
    std::string text;
    for (const Format& format : formats) text += fmt::format("{:<6} {}\n", format.name, format.about);
    return text;
}

int export_design(const ExportOptions& options, Interrupt& interrupt) {
    if (options.list) {
        write_output(list_of_formats());
        return 0;
    }
    const auto format = std::find_if(std::begin(formats), std::end(formats),
                                     [&](const Format& f) { return options.format == f.name; });
    if (format == std::end(formats))
        throw std::runtime_error("export --to " + options.format +
                                 ": this format has not arrived yet; see export --list");
    format->write(options, interrupt);
    return 0;
}

}  // namespace

void declare_export(Command& command, Action& action) {
    const auto options = std::make_shared<ExportOptions>();
    const auto list = command.flag("--list", options->list, "the formats there are");
    const auto design = command.option("DESIGN", options->design, "a .nacre file");
    const auto format = command.option("--to", options->format, "a format of --list");
    const auto output = command.option("-o,--output", options->output, "the file or folder to write");
    add_tolerance_option(command, options->bake);
    command.when_chosen([=, &action] {
        if (!list.given())
            for (const Option needed : {design, format, output}) needed.demand();
        action = [options](Interrupt& interrupt) { return export_design(*options, interrupt); };
    });
}

}  // namespace nacre::cli
