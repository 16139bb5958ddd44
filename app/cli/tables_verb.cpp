#include <fmt/core.h>

#include <iterator>
#include <vector>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/direction_lines.h"
#include "app/cli/output_option.h"
#include "app/cli/verbs.h"
#include "core/bake/bake.h"
#include "core/design/design_file.h"
#include "core/verify/reference.h"

namespace nacre::cli {
namespace {

struct TablesOptions {
    std::string design;
    bool exact = false;
    BakeOptions bake = {.albedo = true};
};

// What `tables` prints of one direction: R0, then R1, once or for each colour.
struct Row {
    double g = 0;
    double P = 0;
    AlbedoValues R = {};
};

void append_row(const Row& row, const AlbedoLayout& layout, bool exact, std::string& text) {
    std::vector<double> numbers = {row.g, row.P};
    const auto with_factor = row.R.begin() + layout.full();
    numbers.insert(numbers.end(), with_factor, with_factor + layout.factors());
    numbers.insert(numbers.end(), row.R.begin(), with_factor);
    const int digits = exact ? 17 : 9;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{:.{}g}", i == 0 ? "" : " ", numbers[i], digits);
    text += '\n';
}

// R0 and R1 are those of f0 = 0 and 1, whatever the design's own Fresnel model; no diffuse term is asked for.
Design with_schlick(Design design) {
    design.fresnel = SchlickFresnel{};
    design.diffuse = NoDiffuse{};
    return design;
}

Row read_tables(const Tables& tables, dvec3 k) {
    const Shading<double>& shading = tables.shading;
    if (k.z < 0) return {.g = tables.distribution->area(k).g};
    const auto spot = shading.table_spot(k);
    Row row;
    row.g = shading.projected_area(k, spot);
    if (row.g > 0) row.P = shading.masking(Shading<double>::known_direction(k, row.g, dvec3{0}));
    row.R = read_albedo(shading, k, tables.needs.fresnel_tables);
    return row;
}

Row integrate(const Reference& reference, dvec3 k, const std::stop_token& stop) {
    Row row{.g = reference.projected_area(k)};
    if (k.z < 0) return row;
    row.P = reference.visibility(k);
    row.R = reference.albedo(k, stop);
    return row;
}

int tables(const TablesOptions& options, const Interrupt& interrupt) {
    const Design design = with_schlick(load_design(options.design));
    if (options.exact) {
        const Reference reference = about_file(options.design, [&] { return Reference(design); });
        answer_lines(
            {.directions = 1, .batch = 256},
            [&](std::span<const dvec3> k, std::string& text) {
                append_row(integrate(reference, k[0], interrupt.token()), reference.layout(), true, text);
            },
            interrupt);
    } else {
        const auto baked = bake_design(design, options.design, options.bake, interrupt);
        answer_lines(
            {.directions = 1},
            [&](std::span<const dvec3> k, std::string& text) {
                append_row(read_tables(*baked, k[0]), baked->needs.layout(), false, text);
            },
            interrupt);
    }
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<TablesOptions>();
    command.option("DESIGN", options->design, "a .nacre file")
        .required()
        .check(no_stream("must be a file, since standard input brings the directions"));
    command.flag("--exact", options->exact, "adaptive integration in double in place of tables; 17 digits");
    add_tolerance_option(command, options->bake);
    command.footer(
        "Reads lines `kx ky kz` (z = normal; any length but 0; # begins a comment line). Prints for each\n"
        "`g P R0 R1`: the projected area of p normalised to 1, the visibility, and the directional albedo\n"
        "for f0 = 0 and f0 = 1. Where the layers' tints differ, R0 and R1 in red, green and blue each: `g P\n"
        "R0r R0g R0b R1r R1g R1b`; a tint that all layers share is left out. The tables hold the upper\n"
        "hemisphere; below the horizon g is computed from p itself, and P, R0 and R1 are 0.");
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return tables(*options, interrupt); };
    });
}

}  // namespace

const Verb tables_verb{"tables", "g, P, R0 and R1 of directions read from standard input", declare};

}  // namespace nacre::cli
