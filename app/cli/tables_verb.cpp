#include <fmt/core.h>

#include <iterator>

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

// What `tables` prints of one direction.
struct Row {
    double g = 0;
    double P = 0;
    double R0 = 0;
    double R1 = 0;
};

void append_row(const Row& row, bool exact, std::string& text) {
    if (exact) {
        fmt::format_to(std::back_inserter(text), "{:.17g} {:.17g} {:.17g} {:.17g}\n", row.g, row.P, row.R0,
                       row.R1);
    } else {
        fmt::format_to(std::back_inserter(text), "{:.9g} {:.9g} {:.9g} {:.9g}\n", row.g, row.P, row.R0,
                       row.R1);
    }
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
    if (row.g > 0) row.P = shading.masking({k, row.g, dvec3{0}});
    const auto albedo = shading.albedo_spot(k, spot);
    const double full = shading.albedo_f1(albedo), kept = shading.clamped_part(k, row.g);
    row.R1 = full * kept;
    row.R0 = shading.fresnel_albedo(albedo, full, Shading<double>::schlick_weight(k.z), 0) * kept;
    return row;
}

Row integrate(const Reference& reference, dvec3 k, const std::stop_token& stop) {
    Row row{.g = reference.projected_area(k)};
    if (k.z < 0) return row;
    row.P = reference.visibility(k);
    const AlbedoValues values = reference.albedo(k, stop);
    row.R1 = values[0];
    row.R0 = values[1];
    return row;
}

int tables(const TablesOptions& options, const Interrupt& interrupt) {
    const Design design = with_schlick(load_design(options.design));
    if (options.exact) {
        const Reference reference = about_file(options.design, [&] { return Reference(design); });
        answer_lines(
            {.directions = 1, .batch = 256},
            [&](std::span<const dvec3> k, std::string& text) {
                append_row(integrate(reference, k[0], interrupt.token()), true, text);
            },
            interrupt);
    } else {
        const auto baked = bake_design(design, options.design, options.bake, interrupt);
        answer_lines(
            {.directions = 1},
            [&](std::span<const dvec3> k, std::string& text) {
                append_row(read_tables(*baked, k[0]), false, text);
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
        "for f0 = 0 and f0 = 1. The tables hold the upper hemisphere; below the horizon g is computed from\n"
        "p itself, and P, R0 and R1 are 0.");
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return tables(*options, interrupt); };
    });
}

}  // namespace

const Verb tables_verb{"tables", "g, P, R0 and R1 of directions read from standard input", declare};

}  // namespace nacre::cli
