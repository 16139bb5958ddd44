#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <iterator>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/direction_lines.h"
#include "app/cli/output_option.h"
#include "app/cli/verbs.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/verify/bounce_oracle.h"
#include "core/verify/reference.h"

namespace nacre::cli {
namespace {

struct EvalOptions {
    std::string design;
    std::string term = "total";
    bool exact = false;
    int walks = 65536;
    BakeOptions bake = {};
};

// The coupled terms read R, which costs most; without them none is needed.
Design only_what_counts(Design design, Term term) {
    if (term != Term::total && term != Term::diffuse && reads_albedo(design.diffuse))
        design.diffuse = NoDiffuse{};
    return design;
}

void append_colour(dvec3 rho, bool exact, std::string& text) {
    rho += 0.0;  // no negative zeros
    if (exact) {
        fmt::format_to(std::back_inserter(text), "{:.17g} {:.17g} {:.17g}\n", rho.x, rho.y, rho.z);
    } else {
        fmt::format_to(std::back_inserter(text), "{:.9g} {:.9g} {:.9g}\n", rho.x, rho.y, rho.z);
    }
}

void answer_from_tables(const Design& design, const EvalOptions& options, Term term,
                        const Interrupt& interrupt) {
    const Brdf brdf(bake_design(design, options.design, options.bake, interrupt));
    answer_lines(
        {.directions = 2},
        [&](std::span<const dvec3> k, std::string& text) {
            append_colour(brdf.evaluate(k[0], k[1], term), false, text);
        },
        interrupt);
}

// rho of a term that may hold multiple bounces, and the largest standard error of any colour that these have.
dvec3 exact_term(const Reference& reference, const Design& design, const EvalOptions& options, Term term,
                 std::span<const dvec3> k, double& error, const std::stop_token& stop) {
    dvec3 rho{0};
    if (term != Term::multibounce)
        rho = brdf_term(reference.shading(), reference.direction(k[0], stop), reference.direction(k[1], stop),
                        term);
    const bool bounces =
        has_bounces(design.multibounce) && (term == Term::total || term == Term::multibounce);
    if (!bounces) return rho;
    const double weight = reference.shading().surface.ks;
    const WalkEstimate walked = BounceOracle(reference).rho(k[0], k[1], {.walks = options.walks}, stop);
    error = weight * std::max({walked.error.x, walked.error.y, walked.error.z});
    return rho + weight * walked.mean;
}

void answer_exactly(const Design& design, const EvalOptions& options, Term term, const Interrupt& interrupt) {
    const std::stop_token stop = interrupt.token();
    Reference reference = about_file(options.design, [&] { return Reference(design); });
    reference.set_walks(options.walks);
    reference.prepare_coupling(stop);
    std::atomic<double> worst = 0;  // standard error
    answer_lines(
        {.directions = 2, .batch = 256},
        [&](std::span<const dvec3> k, std::string& text) {
            dvec3 rho{0};
            if (k[0].z > 0 && k[1].z > 0) {
                double error = 0;
                rho = exact_term(reference, design, options, term, k, error, stop);
                for (double known = worst; known < error && !worst.compare_exchange_weak(known, error);) {
                }
            }
            append_colour(rho, true, text);
        },
        interrupt);
    if (worst > 0)
        fmt::print(stderr, "multiple bounces by {} walks a line: standard error at most {:.2g}\n",
                   options.walks, worst.load());
}

int eval(const EvalOptions& options, const Interrupt& interrupt) {
    const auto term = term_by_name(options.term);
    const Design design = only_what_counts(load_design(options.design), *term);
    if (options.exact) {
        answer_exactly(design, options, *term, interrupt);
    } else {
        answer_from_tables(design, options, *term, interrupt);
    }
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<EvalOptions>();
    command.option("DESIGN", options->design, "a .nacre file")
        .required()
        .check(no_stream("must be a file, since standard input brings the directions"));
    command.option("--term", options->term, fmt::format("{} (default total)", fmt::join(term_names(), ", ")))
        .one_of(term_names());
    const auto exact =
        command.flag("--exact", options->exact, "adaptive integration in double in place of tables; 17 digits");
    command
        .option("--walks", options->walks,
                "with --exact: random walks a line, for multiple bounces (default 65536)")
        .within(1, 1e8)
        .needs(exact);
    add_tolerance_option(command, options->bake);
    command.footer(
        "Reads lines `k1x k1y k1z k2x k2y k2z` (z = normal; any length but 0; # begins a comment line).\n"
        "Prints for each `r g b`, the BRDF in 1/sr; 0 0 0 where either is not above the horizon.");
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return eval(*options, interrupt); };
    });
}

}  // namespace

const Verb eval_verb{"eval", "the BRDF of pairs of directions read from standard input", declare};

}  // namespace nacre::cli
