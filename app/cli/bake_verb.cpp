#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/cli/bake_options.h"
#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/table_output.h"
#include "app/cli/verbs.h"
#include "core/formats/error_json.h"
#include "core/formats/table_files.h"

namespace nacre::cli {
namespace {

struct BakeVerbOptions {
    std::string design;
    std::string folder;
    BakeOptions bake = {};
    bool json = false;
};

std::string json_summary(const WrittenTables& written, const std::string& folder) {
    const Tables& tables = *written.tables;
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const TablePicture& picture : table_pictures(tables))
        files.push_back({{"file", picture.file},
                         {"width", picture.size.x},
                         {"height", picture.size.y},
                         {"channels", picture.channels.size()},
                         {"bytes", picture.values.size() * sizeof(float)}});
    const nlohmann::ordered_json json = {{"folder", folder},
                                         {"seconds", tables.seconds},
                                         {"symmetry", name_of(tables.needs.symmetry.symmetry)},
                                         {"table_bytes", tables.table_floats() * sizeof(float)},
                                         {"tables", std::move(files)},
                                         {"errors",
                                          {{"tolerance", tables.tolerance},
                                           {"by_the_bake", errors_json(tables.errors)},
                                           {"against_exact", errors_json(written.errors)}}}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string text_summary(const WrittenTables& written, const std::string& folder) {
    const Tables& tables = *written.tables;
    std::string text = fmt::format("{}\n", folder);
    for (const TablePicture& picture : table_pictures(tables))
        text += fmt::format("  {:<24} {:>5} x {:<5} {:>8} bytes\n", picture.file, picture.size.x,
                            picture.size.y, picture.values.size() * sizeof(float));
    text += fmt::format("  {:<24}\n", "manifest.json");
    text += fmt::format("baked in {:.3f} s, symmetry {}\n", tables.seconds,
                        name_of(tables.needs.symmetry.symmetry));
    const auto line = [](const char* quantity, const TableError& error) {
        return fmt::format("  {:<24} worst {:.1e}, root mean square {:.1e}, {} directions\n", quantity,
                           error.worst, error.root_mean_square, error.directions);
    };
    text += fmt::format("error against the exact reference, {:.1e} wanted:\n", tables.tolerance);
    text += line("g, relative", written.errors.area) + line("R, absolute", written.errors.albedo);
    if (tables.shading.kinds.matt_facets()) text += line("matt facets, absolute", written.errors.facets);
    return text;
}

int bake_to_folder(const BakeVerbOptions& options, Interrupt& interrupt) {
    const WrittenTables written = write_tables(options.design, options.folder, options.bake, interrupt);
    write_output(options.json ? json_summary(written, options.folder)
                              : text_summary(written, options.folder));
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<BakeVerbOptions>();
    command.option("DESIGN", options->design, "a .nacre file; - is standard input").required();
    add_folder_option(command, options->folder, "the folder for the tables, made when it is not there");
    command
        .option("--threads", options->bake.threads,
                "at most this many (default: all); the tables do not depend on it")
        .within(1, 1024);
    add_tolerance_option(command, options->bake);
    command.flag("--json", options->json, "times, sizes and measured errors as JSON");
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return bake_to_folder(*options, interrupt); };
    });
}

}  // namespace

const Verb bake_verb{"bake", "bake a design and write its tables with their manifest", declare};

}  // namespace nacre::cli
