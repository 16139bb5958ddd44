#include "core/verify/physics_check.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/design/design_check.h"
#include "core/verify/albedo_check.h"
#include "core/verify/bounce_check.h"
#include "core/verify/effort.h"
#include "core/verify/facet_integral.h"
#include "core/verify/sampling_check.h"
#include "core/verify/sampling_density.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double smooth_tolerance = 1e-6, picture_tolerance = 2e-4;  // of an integral over p
constexpr double upright_degrees = 0.01;                             // H counts as parallel to n
constexpr int furnace_directions = 8, total_directions = 200;
constexpr int reciprocity_pairs = 20000, least_pairs = 2000;
constexpr double reciprocity_seconds = 5;  // of the processor
constexpr int coat_directions = 4, coat_samples = 65536;
constexpr double coat_bound = 0.03;
constexpr double most_surprise = 6;  // one false alarm in a million designs

Verdict verdict(bool good) { return good ? Verdict::pass : Verdict::fail; }

class PhysicsCheckRun {
  public:
    PhysicsCheckRun(const Design& design, std::stop_token stop, const std::function<void(double)>& progress)
        : design_(design),
          stop_(std::move(stop)),
          progress_(progress),
          with_picture_(holds_picture(design.distribution)),
          tables_(bake(design, {.albedo = true}, stop_, [&](double done) { report(0.3 * done); })),
          reference_(design) {}

    PhysicsReport run() {
        check_integrals();
        report(0.4);
        check_reciprocity();
        report(0.45);
        const AlbedoCheck albedo = measure_albedo(*tables_, reference_, stop_);
        add("albedo", albedo.worst, 1 + 1e-6, verdict(albedo.violations == 0),
            fmt::format("largest R at F = 1; above 1 in {} of {} directions", albedo.violations,
                        albedo.directions) +
                (albedo.unsettled == 0 ? std::string()
                                       : fmt::format(", not told from 1 in {}", albedo.unsettled)));
        check_mean_normal(albedo.violations > 0);
        report(0.6);
        check_tables();
        report(0.75);
        check_sampling();
        report(0.9);
        check_density();
        if (design_.specular.intensity > 1) check_intensity();
        if (tables_->bounces) check_bounces();
        if (is_coated(design_.coat)) check_coat();
        report(1);
        return result_;
    }

  private:
    void report(double done) const {
        if (stop_.stop_requested()) throw BakeCancelled();
        if (progress_) progress_(done);
    }

    void add(const char* name, double figure, double bound, Verdict what, std::string text) {
        result_.checks.push_back({name, what, figure, bound, std::move(text)});
    }

    void check_integrals() {
        const FacetDistribution& distribution = *tables_->distribution;
        const std::vector<dvec3> directions = probe_directions(with_picture_ ? 2 : furnace_directions);
        std::vector<double> whole(directions.size()), visible(directions.size());
        tbb::parallel_for(std::size_t{0}, directions.size(), [&](std::size_t i) {
            const FacetIntegral integral =
                integrate_facets(design_.distribution, distribution, directions[i], stop_);
            const double g = distribution.projected_area(directions[i]);
            whole[i] = std::fabs(integral.whole - 1);
            visible[i] = g == 0 ? integral.visible : std::fabs(integral.visible / g - 1);
        });
        const double bound = with_picture_ ? picture_tolerance : smooth_tolerance;
        const double p = summarise(whole).worst, g = summarise(visible).worst;
        add("normalisation", p, bound, verdict(p <= bound), "|integral of p - 1|");
        add("white furnace", g, bound, verdict(g <= bound), "worst |integral of (k.h)+ p / g(k) - 1|");
    }

    // Half of the pairs are where the highlight is, the others anywhere, some of them grazing.
    void check_reciprocity() {
        const Brdf brdf(tables_);
        Random random(1);
        int wrong = 0, pairs = 0;
        const Effort effort(reciprocity_seconds);
        for (; pairs < reciprocity_pairs && (pairs < least_pairs || effort.left()); ++pairs) {
            const int i = pairs;
            if (i % 256 == 0) report(0.4 + 0.05 * i / reciprocity_pairs);
            const double c = i % 5 == 0 ? 1e-6 : uniform_random(random);
            const double phi = 2 * pi * uniform_random(random), sine = std::sqrt((1 - c) * (1 + c));
            const dvec3 a{sine * std::cos(phi), sine * std::sin(phi), c};
            dvec3 b = glm::normalize(dvec3{uniform_random(random) - 0.5, uniform_random(random) - 0.5,
                                           1e-6 + uniform_random(random)});
            if (i % 2 == 0)
                if (const auto sample = brdf.sample(a, random)) b = sample->k2;
            const dvec3 there = brdf.evaluate(a, b), back = brdf.evaluate(b, a);
            bool good = there == back;
            for (int channel = 0; channel < 3; ++channel)
                good = good && std::isfinite(there[channel]) && there[channel] >= 0;
            wrong += good ? 0 : 1;
        }
        add("reciprocity", wrong, 0, verdict(wrong == 0),
            fmt::format("of {} pairs: differ in a bit, negative or not finite", pairs));
    }

    void check_mean_normal(bool creates_energy) {
        const dvec3 mean = tables_->mean;
        const double angle = std::atan2(std::hypot(mean.x, mean.y), mean.z) * 180 / pi;
        const bool upright = angle <= upright_degrees;
        const bool creates = !upright && !design_.shadowing.clamp && creates_energy;
        const bool fails = creates || std::isnan(angle);
        add("mean normal", angle, upright_degrees,
            upright ? Verdict::pass
            : fails ? Verdict::fail
                    : Verdict::note,
            upright ? "degrees between <h> and n"
            : creates
                ? "degrees between <h> and n: p is no height field's, and without clamp it creates energy"
                : "degrees between <h> and n: p is no height field's");
    }

    // The tables must be as good as the bake says, which is the promise that a renderer relies on. That they
    // are as good as was wanted is another question: a p with more detail than the largest tables hold breaks
    // no physics, and its bake reports the error.
    void check_tables() {
        const TableErrors errors = measure_table_errors(*tables_, reference_, stop_);
        check_table("table of g", "tolerance of g", errors.area, tables_->errors.area);
        check_table("tables of R", "tolerance of R", errors.albedo, tables_->errors.albedo);
        if (!tables_->shading.kinds.matt_facets()) return;
        const TableError& claim = tables_->errors.facets;
        const double most = allowed_error(claim, tables_->tolerance);
        add("matt facets", errors.facets.worst, most,
            verdict(std::isfinite(most) && errors.facets.worst <= most),
            fmt::format("worst error of what they show of each other, {} pairs; the bake claims {:.2e}",
                        errors.facets.directions, claim.worst));
    }

    void check_table(const char* name, const char* wish, const TableError& measured,
                     const TableError& claim) {
        const double tolerance = tables_->tolerance;
        const bool kept = claim.worst <= tolerance;
        const double most = allowed_error(claim, tolerance);
        add(name, measured.worst, most, verdict(std::isfinite(most) && measured.worst <= most),
            fmt::format("worst error, {} directions; the bake claims {:.2e}", measured.directions,
                        claim.worst));
        add(wish, claim.worst, tolerance, kept ? Verdict::pass : Verdict::note,
            kept ? "worst error that the bake claims"
                 : "worst error that the bake claims: within 256 KiB it found no tables that keep closer");
    }

    void check_sampling() {
        const SamplingCheck sampling = measure_sampling(*tables_, stop_);
        const bool valid = design_.shadowing.clamp || result_.checks[3].verdict == Verdict::pass;
        add("sampling weight", sampling.weight, 1e-3,
            sampling.weight <= 1e-3 ? Verdict::pass
            : valid                 ? Verdict::fail
                                    : Verdict::note,
            "largest weight/F - 1 of a visible facet");
        const double bound = 0.02 * std::fmax(1.0, sampling.weight + 1);
        add("sampling mean", sampling.mean, bound, verdict(std::isfinite(bound) && sampling.mean <= bound),
            fmt::format("worst |mean weight - R|, {} directions", sampling.directions));
    }

    void check_density() {
        const SamplingDensity density = measure_sampling_density(tables_, stop_);
        add("sampling density", density.surprise, most_surprise, verdict(density.surprise <= most_surprise),
            fmt::format(
                "-log10 of the chance of samples so far from the pdf, {} directions, {} samples each, "
                "{} bins (chi-square)",
                density.directions, density.samples, density.bins));
    }

    // Above 1 the specular term is more than its facets reflect. The tables are those of intensity 1, so that
    // no check before knows of it; it fails where it makes the whole BRDF send back more than it gets.
    void check_intensity() {
        double most = 0;
        for (const dvec3 k : probe_directions(total_directions)) {
            const dvec3 total = tables_->shading.coated_albedo(tables_->shading.direction(k));
            most = worse_error(most, std::max({total.x, total.y, total.z}));
        }
        add("intensity", most, 1, most <= 1 ? Verdict::note : Verdict::fail,
            fmt::format("{}: the largest albedo of the whole BRDF, {} directions",
                        energy_note(design_.specular.intensity), total_directions));
    }

    // The albedo of the whole at F = 1 is 1; R's own error is one of what the bounces bring.
    void check_bounces() {
        const BounceCheck bounces = measure_bounces(*tables_, stop_);
        const double bound = std::max(tables_->errors.albedo.worst, tables_->tolerance);
        add("bounces", bounces.furnace, bound, verdict(bounces.furnace <= bound),
            fmt::format("white furnace: worst |1 - R - what bounces bring| at F = 1, {} directions",
                        bounces.directions));
    }

    // Samples of the whole BRDF against the albedo that the coat's tables hold.
    void check_coat() {
        const Brdf brdf(tables_);
        double off = 0;
        for (const dvec3 k : probe_directions(coat_directions)) {
            report(0.95);
            const BrdfSampler sampler(brdf, k);
            Random random(1);
            dvec3 sum{0};
            for (int i = 0; i < coat_samples; ++i)
                if (const auto sample = sampler(random)) sum += sample->weight;
            const dvec3 error = glm::abs(sum / double{coat_samples} - brdf.total_albedo(k));
            for (int c = 0; c < 3; ++c) off = worse_error(off, error[c]);
        }
        add("coat", off, coat_bound, verdict(off <= coat_bound),
            fmt::format("worst |mean weight of all samples - albedo of the whole|, {} directions",
                        coat_directions));
    }

    const Design& design_;
    std::stop_token stop_;
    const std::function<void(double)>& progress_;
    bool with_picture_;
    std::shared_ptr<const Tables> tables_;
    Reference reference_;
    PhysicsReport result_;
};

}  // namespace

bool PhysicsReport::passed() const {
    return std::none_of(checks.begin(), checks.end(),
                        [](const PhysicsCheck& check) { return check.verdict == Verdict::fail; });
}

PhysicsReport check_physics(const Design& design, std::stop_token stop,
                            const std::function<void(double)>& progress) {
    return PhysicsCheckRun(design, std::move(stop), progress).run();
}

}  // namespace nacre
