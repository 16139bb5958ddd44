#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <optional>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/direction_lines.h"
#include "app/cli/output_option.h"
#include "app/cli/verbs.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/verify/bounce_oracle.h"
#include "core/verify/coat_oracle.h"
#include "core/verify/facet_oracle.h"
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

// A term without tables: what is integrated, and what walks have to say of multiple bounces and of matt
// facets.
class ExactTerm {
  public:
    ExactTerm(const Reference& reference, const Design& design, Term term, int walks)
        : reference_(reference), term_(term), walks_(walks) {
        const bool whole = term == Term::total;
        if (is_coated(design.coat)) coat_.emplace(design);
        if (has_bounces(design.multibounce) && (whole || term == Term::multibounce))
            bounces_.emplace(reference);
        if (has_matt_facets(design.diffuse) && (whole || term == Term::diffuse)) facets_.emplace(reference);
    }

    // Both above the horizon. The standard error is that of the walks.
    WalkEstimate operator()(dvec3 k1, dvec3 k2, const std::stop_token& stop) const {
        if (!coat_) return beneath(k1, k2, stop);
        if (is_factor(term_)) return beneath(coat_->inside(k1), coat_->inside(k2), stop);
        WalkEstimate sum;
        if (term_ != Term::coat)
            add(beneath(coat_->inside(k1), coat_->inside(k2), stop), coat_->passage(k1, k2), sum);
        if (term_ == Term::coat || term_ == Term::total) sum.mean += coat_->reflection(k1, k2);
        return sum;
    }

  private:
    // In the medium that the facets lie in.
    WalkEstimate beneath(dvec3 k1, dvec3 k2, const std::stop_token& stop) const {
        WalkEstimate sum;
        if (term_ != Term::multibounce)
            sum.mean = brdf_term(reference_.shading(), reference_.direction(k1, stop),
                                 reference_.direction(k2, stop), term_);
        const dvec3 ks{reference_.shading().surface.ks};
        if (bounces_) add(bounces_->rho(k1, k2, {.walks = walks_}, stop), ks, sum);
        if (facets_) add(facets_->rho(k1, k2, {.walks = walks_, .first = 1}, stop), dvec3{1}, sum);
        return sum;
    }

    static void add(const WalkEstimate& walked, dvec3 weight, WalkEstimate& sum) {
        sum.mean += weight * walked.mean;
        sum.error += weight * walked.error;
    }

    const Reference& reference_;
    Term term_;
    int walks_;
    std::optional<BounceOracle> bounces_;
    std::optional<FacetOracle> facets_;
    std::optional<CoatOracle> coat_;
};

void answer_exactly(const Design& design, const EvalOptions& options, Term term, const Interrupt& interrupt) {
    const std::stop_token stop = interrupt.token();
    Reference reference = about_file(options.design, [&] { return Reference(design); });
    reference.set_walks(options.walks);
    reference.prepare_coupling(stop);
    const ExactTerm exact(reference, design, term, options.walks);
    std::atomic<double> worst = 0;  // standard error
    answer_lines(
        {.directions = 2, .batch = 256},
        [&](std::span<const dvec3> k, std::string& text) {
            WalkEstimate rho;
            if (k[0].z > 0 && k[1].z > 0) rho = exact(k[0], k[1], stop);
            const double error = std::max({rho.error.x, rho.error.y, rho.error.z});
            for (double known = worst; known < error && !worst.compare_exchange_weak(known, error);) {
            }
            append_colour(rho.mean, true, text);
        },
        interrupt);
    if (worst > 0)
        fmt::print(stderr, "bounces between facets by {} walks a line: standard error at most {:.2g}\n",
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
    const auto exact = command.flag("--exact", options->exact,
                                    "adaptive integration in double in place of tables; 17 digits");
    command
        .option("--walks", options->walks,
                "with --exact: random walks a line, for light that bounces between facets (default 65536)")
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
