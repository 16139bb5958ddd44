#include "core/bake/table_fits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bake/fitted.h"

namespace nacre {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// What of the tolerance the errors may take by which a size is chosen; the rest is for what a search finds.
constexpr double area_part = 0.75, albedo_part = 0.8;

// What a reader of the tables may find more than they claim: see allowed_error().
constexpr double claim_slack = 1.25;

// Floats of all tables of a design, 64 KiB, and what of them g may take; where that does not suffice, at most
// so many times as many.
constexpr int floats_usual = 16384, area_floats_usual = 7424, growth_max = 4;

// What a direction costs is the lobes' sum, where a picture counts as so many smooth ones; tables grow less
// where it is more than the budget allows.
constexpr int picture_cost = 4, growth_budget = 64;

// Directions by which R is measured.
constexpr int final_probes = 160, draft_probes = 16;

// Of the worst of them, where the quadrature itself is looked at, and how often it is made finer.
constexpr std::size_t rule_trials = 6;
constexpr int rule_rounds = 2;

// From here on the form of g that leaves out the moment is tried too.
constexpr double strong_lean = 0.15;

// The error of g that is good enough for a draft of a tilted p.
constexpr double draft_enough = 0.02;

// Of the mean normal of the facets above the horizon, as a slope; 0 where it is rounding.
double lean_of(const FacetDistribution& distribution) {
    const dvec3 moment = distribution.area({0, 0, 1}).gradient;
    const double slope = std::hypot(moment.x, moment.y) / moment.z;
    return slope > 1e-9 ? slope : 0;
}

int growth_of(const FacetDistribution& distribution) {
    int cost = 0;
    for (const PlacedLobe& placed : distribution.lobes())
        cost += placed.lobe->spans().empty() ? picture_cost : 1;
    return std::clamp(growth_budget / std::max(cost, 1), 1, growth_max);
}

class AreaMaker {
  public:
    using Result = Fitted<AreaTable>;

    AreaMaker(const std::shared_ptr<const FacetDistribution>& distribution,
              const DistributionSymmetry& symmetry, const BakeOptions& options,
              const Shading<double>& material, Workers& workers)
        : distribution_(distribution),
          symmetry_(symmetry),
          quality_(options.quality),
          enough_(options.tolerance / claim_slack),
          material_(material),
          workers_(workers) {}

    void leave_out_moment(bool without) { without_moment_ = without; }

    Result make(TableNodes nodes) {
        Result result;
        result.nodes = nodes;
        result.table = std::make_shared<const AreaTable>(distribution_, symmetry_, nodes, without_moment_,
                                                         quality_, workers_);
        result.error = result.table->measure(material_);
        result.table->tell(known_);
        return result;
    }

    void search(Result& result, Search how = Search::usual) {
        if (quality_ == Quality::draft) return;
        result.table->search(material_, enough_, how, result.error, known_, workers_);
        result.error.all.worst = shared(result);
    }

    double shared(const Result& result) const {
        return worse_error(result.error.all.worst, result.table->worst_at(material_, known_, workers_));
    }

  private:
    std::shared_ptr<const FacetDistribution> distribution_;
    DistributionSymmetry symmetry_;
    Quality quality_;
    double enough_;
    const Shading<double>& material_;
    Workers& workers_;
    bool without_moment_ = false;
    std::vector<KnownArea> known_;
};

class AlbedoMaker {
  public:
    using Result = Fitted<AlbedoTable>;

    AlbedoMaker(AlbedoSampling& rules, Quality quality, double tolerance, Workers& workers)
        : rules_(rules), quality_(quality), enough_(tolerance), workers_(workers) {}

    Result make(TableNodes nodes) {
        Result result;
        result.nodes = nodes;
        result.table = std::make_shared<const AlbedoTable>(rules_, nodes, workers_);
        result.error = result.table->measure();
        result.table->tell(known_);
        return result;
    }

    void search(Result& result, Search how = Search::usual) {
        if (quality_ == Quality::draft) return;
        result.table->search(enough_, how, result.error, known_, workers_);
        result.error.all.worst = shared(result);
    }

    double shared(const Result& result) const {
        return worse_error(result.error.all.worst, result.table->worst_at(known_));
    }

    // Whether the error is that of the quadrature, which is then refined; nothing is known by the new one.
    bool refine_rules(const Result& result) {
        if (!rules_.refine_at(result.table->worst_of(known_, rule_trials))) return false;
        known_.clear();
        return true;
    }

  private:
    AlbedoSampling& rules_;
    Quality quality_;
    double enough_;
    Workers& workers_;
    std::vector<KnownAlbedo> known_;
};

// Of two tables: the smaller where both keep to what was wanted, else the one with the smaller error.
bool first_is_better(const AreaMaker& maker, const Fitted<AreaTable>& a, const Fitted<AreaTable>& b) {
    if (a.kept && b.kept) return a.nodes.polar * a.nodes.azimuth < b.nodes.polar * b.nodes.azimuth;
    return maker.shared(a) < maker.shared(b);
}

TableSize beginning(Symmetry symmetry, const BakeOptions& options) {
    return options.size ? *options.size : first_size(symmetry, options.quality);
}

}  // namespace

FittedArea fit_area(const std::shared_ptr<const FacetDistribution>& distribution, const Needs& needs,
                    const BakeOptions& options, const Shading<double>& material, Workers& workers) {
    const bool draft = options.quality == Quality::draft, fixed = draft || options.size.has_value();
    const double tolerance = fixed ? never : options.tolerance;
    const FitWishes wishes{fixed ? never : area_part * tolerance, tolerance, fixed ? 0 : area_floats_usual,
                           fixed ? 0 : growth_of(*distribution) * area_floats_usual};
    const TableSize size = beginning(needs.symmetry.symmetry, options);
    const TableNodes first{size.w, size.psi};
    AreaMaker maker(distribution, needs.symmetry, options, material, workers);
    TableFit<AreaMaker> with(maker, needs.symmetry.symmetry, wishes), without = with;
    TableFit<AreaMaker>* taken = &with;
    Fitted<AreaTable> fitted = with.within_limit(first);
    const double leaning = lean_of(*distribution);
    const bool missed = draft ? fitted.error.all.worst > draft_enough : fixed || !fitted.kept;
    maker.leave_out_moment(true);
    // Where the first form is good enough, the other is only fitted if its smallest table has half the error.
    auto promising = [&] {
        return !fixed && maker.make(first).error.all.worst < 0.5 * with.tried().front().worst;
    };
    if (leaning > (missed && !fixed ? 0 : strong_lean) && (missed || promising())) {
        const Fitted<AreaTable> other = without.within_limit(first);
        if (first_is_better(maker, other, fitted)) {
            fitted = other;
            taken = &without;
        }
    }
    maker.leave_out_moment(taken == &without);
    fitted = taken->beyond(fitted);
    // What does not keep to the tolerance is claimed for what it is.
    if (fitted.error.all.worst > tolerance) maker.search(fitted, Search::thorough);
    return {fitted.table, fitted.error, fitted.nodes, taken->tried()};
}

FittedAlbedo fit_albedo(const AreaTable& area, const AxisError& area_error, const Needs& needs,
                        const BakeOptions& options, const Shading<double>& material, Workers& workers) {
    const bool draft = options.quality == Quality::draft, fixed = draft || options.size.has_value();
    const double tolerance = options.tolerance;
    const AlbedoTolerance effort = draft ? AlbedoTolerance{never, tolerance, draft_probes}
                                         : AlbedoTolerance{0.3 * tolerance, 0.1 * tolerance, final_probes};
    // g's own error adds to R's.
    const double rest = std::max(tolerance - area_error.all.root_mean_square, 0.3 * tolerance);
    const double target =
        std::max(albedo_part * tolerance - area_error.all.root_mean_square, 0.3 * tolerance);
    const int area_floats = static_cast<int>(area.data().size()), tables = needs.layout().size();
    const int usual = std::max(floats_usual - area_floats, floats_usual - area_floats_usual) / tables;
    const FitWishes wishes{
        fixed ? never : target, fixed ? never : rest, fixed ? 0 : usual,
        fixed ? 0 : std::max(growth_of(*area.distribution()) * floats_usual - area_floats, 0) / tables};
    AlbedoSampling rules(area, material, needs.fresnel_tables, effort);
    AlbedoMaker maker(rules, options.quality, tolerance / claim_slack - area_error.all.root_mean_square,
                      workers);
    TableFit<AlbedoMaker> fit(maker, needs.symmetry.symmetry, wishes);
    const TableSize size = beginning(needs.symmetry.symmetry, options);
    const TableNodes first{size.v, size.rho};
    Fitted<AlbedoTable> fitted = fit.within_limit(first);
    for (int round = 0; round < rule_rounds && fitted.error.all.worst > wishes.tolerance; ++round) {
        if (!maker.refine_rules(fitted)) break;
        fitted = fit.within_limit(first);
    }
    fitted = fit.beyond(fitted);
    if (fitted.error.all.worst > wishes.tolerance) maker.search(fitted, Search::thorough);
    return {fitted.table->data(), fitted.error.all, fitted.nodes, fit.tried()};
}

}  // namespace nacre
