#include "core/study/extreme_check.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/model/float_shading.h"

namespace nacre {
namespace {

using std::numbers::pi;

// rho of two designs that differ in the unit of p alone: relative, and 1/sr where digits run out.
constexpr double same = 1e-5, same_nothing = 1e-30;

dvec3 at_height(double cosine, double phi) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// The normal, and on, below and hardly above the horizon, each with its opposite along the surface.
std::vector<dvec3> edge_directions() {
    std::vector<dvec3> edges = {{0, 0, 1}};
    for (const double c : {1e-6, 1e-40, 1e-300, std::numeric_limits<double>::denorm_min(), 0.0, -0.1})
        for (const double phi : {0.0, 1.1}) {
            const dvec3 k = at_height(c, phi);
            edges.push_back(k);
            edges.push_back({-k.x, -k.y, k.z});
        }
    return edges;
}

// Every two edges; then k2 where the highlight is and anywhere, some of k1 grazing.
std::vector<DirectionPair> judged_pairs(const Brdf& brdf, int count) {
    std::vector<DirectionPair> pairs;
    const std::vector<dvec3> edges = edge_directions();
    for (const dvec3 a : edges)
        for (const dvec3 b : edges) pairs.push_back({a, b});
    Random random(1);
    for (int i = 0; i < count; ++i) {
        const dvec3 a =
            at_height(i % 5 == 0 ? 1e-6 : uniform_random(random), 2 * pi * uniform_random(random));
        const dvec3 b = at_height(uniform_random(random), 2 * pi * uniform_random(random));
        const auto sample = i % 2 == 0 ? brdf.sample(a, random) : std::nullopt;
        pairs.push_back({a, sample ? sample->k2 : b});
    }
    return pairs;
}

class Judgement {
  public:
    Judgement(const ExtremeCase& extreme, std::shared_ptr<const Tables> tables, const ExtremeOptions& options,
              std::stop_token stop)
        : extreme_(extreme),
          tables_(std::move(tables)),
          options_(options),
          stop_(std::move(stop)),
          reference_(extreme.design),
          brdf_(tables_),
          pairs_(judged_pairs(brdf_, options.pairs)) {}

    ExtremeResult run() {
        result_.pairs = static_cast<int>(pairs_.size());
        check_numbers();
        check_pairs("double", [&](const DirectionPair& p) { return brdf_.evaluate(p.k1, p.k2); });
        const Shading<float> shading = in_float(tables_->shading);
        check_pairs("float", [&](const DirectionPair& p) {
            return dvec3(shading.brdf(glm::vec3(p.k1), glm::vec3(p.k2)));
        });
        check_energy();
        check_claims();
        if (extreme_.same_rho) check_same();
        if (options_.plain_method)
            result_.plain = measure_plain_method(*tables_, pairs_, probe_directions(options_.probes.area),
                                                 probe_directions(options_.probes.albedo), stop_);
        return std::move(result_);
    }

  private:
    void expect(bool good, std::string fault) {
        if (stop_.stop_requested()) throw BakeCancelled();
        if (!good) result_.faults.push_back(std::move(fault));
    }

    void check_numbers() {
        const auto bad = std::count_if(tables_->data.begin(), tables_->data.end(),
                                       [](float x) { return !std::isfinite(x); });
        expect(bad == 0, fmt::format("{} numbers of the tables are not finite", bad));
    }

    template <class Rho>
    void check_pairs(const char* precision, const Rho& rho) {
        int unsound = 0, changed = 0, below = 0;
        for (const DirectionPair& pair : pairs_) {
            const dvec3 there = rho(pair), back = rho({pair.k2, pair.k1});
            bool sound = true, bright = false;
            for (int i = 0; i < 3; ++i) {
                sound = sound && std::isfinite(there[i]) && there[i] >= 0;
                bright = bright || there[i] != 0;
            }
            unsound += sound ? 0 : 1;
            changed += there == back ? 0 : 1;
            below += bright && (pair.k1.z <= 0 || pair.k2.z <= 0) ? 1 : 0;
        }
        const std::size_t count = pairs_.size();
        expect(unsound == 0,
               fmt::format("rho is not finite or negative in {} of {} pairs, {}", unsound, count, precision));
        expect(changed == 0,
               fmt::format("rho is not reciprocal in {} of {} pairs, {}", changed, count, precision));
        expect(below == 0,
               fmt::format("rho is not 0 below the horizon in {} of {} pairs, {}", below, count, precision));
    }

    void check_energy() {
        const AlbedoCheck albedo = measure_albedo(*tables_, reference_, stop_, options_.rings);
        result_.largest_albedo = albedo.worst;
        if (!extreme_.design.shadowing.clamp) return;
        expect(albedo.violations == 0, fmt::format("R with F = 1 is {:.6g}, above 1 in {} of {} directions",
                                                   albedo.worst, albedo.violations, albedo.directions));
    }

    void check_claims() {
        const TableErrors measured = measure_table_errors(*tables_, reference_, stop_, options_.probes);
        const TableErrors& claimed = tables_->errors;
        auto bound = [&](const TableError& own) { return allowed_error(own, tables_->tolerance); };
        result_.area = {measured.area.worst, bound(claimed.area)};
        result_.albedo = {measured.albedo.worst, bound(claimed.albedo)};
        auto check = [&](const char* what, const ClaimedError& error, const TableError& own, double most) {
            expect(std::isfinite(error.bound) && error.error <= error.bound,
                   fmt::format("{} has an error of {:.2e}, the bake claims {:.2e}", what, error.error,
                               error.bound));
            expect(own.worst <= most, fmt::format("the bake claims {:.2e} for {}, {:.1e} can be expected",
                                                  own.worst, what, most));
        };
        check("g", result_.area, claimed.area, extreme_.area_claim);
        check("R", result_.albedo, claimed.albedo, extreme_.albedo_claim);
        if (tables_->shading.kinds.matt_facets()) {
            const double most = bound(claimed.facets);
            expect(std::isfinite(most) && measured.facets.worst <= most,
                   fmt::format("matt facets have an error of {:.2e}, the bake claims {:.2e}",
                               measured.facets.worst, most));
        }
        if (extreme_.design.shadowing.clamp) check_total();
    }

    // The whole BRDF in a white environment, by its tables. An intensity I makes I R + 1 - R of 1 at most.
    void check_total() {
        const double bound = std::fmax(extreme_.design.specular.intensity, 1) * (1 + result_.albedo.bound);
        int bright = 0;
        const std::vector<dvec3> probes = probe_directions(options_.probes.area);
        for (const dvec3 k : probes) {
            const dvec3 total = tables_->shading.coated_albedo(tables_->shading.direction(k));
            bright += total.x <= bound && total.y <= bound && total.z <= bound ? 0 : 1;
        }
        expect(bright == 0, fmt::format("the whole BRDF reflects more than {:.6g} in {} of {} directions",
                                        bound, bright, probes.size()));
    }

    void check_same() {
        const Brdf other(bake(*extreme_.same_rho, {.albedo = true}, stop_));
        const Shading<float> shading = in_float(tables_->shading),
                             other_shading = in_float(other.tables().shading);
        int different = 0;
        auto compare = [&](dvec3 a, dvec3 b) {
            for (int i = 0; i < 3; ++i)
                if (!(std::fabs(a[i] - b[i]) <= same * std::fmax(a[i], b[i]) + same_nothing)) return 1;
            return 0;
        };
        for (const DirectionPair& pair : pairs_) {
            const glm::vec3 k1(pair.k1), k2(pair.k2);
            different += compare(brdf_.evaluate(pair.k1, pair.k2), other.evaluate(pair.k1, pair.k2)) |
                         compare(dvec3(shading.brdf(k1, k2)), dvec3(other_shading.brdf(k1, k2)));
        }
        expect(different == 0, fmt::format("rho is not that of p in another unit in {} of {} pairs",
                                           different, pairs_.size()));
    }

    const ExtremeCase& extreme_;
    const std::shared_ptr<const Tables> tables_;
    const ExtremeOptions& options_;
    const std::stop_token stop_;
    const Reference reference_;
    const Brdf brdf_;
    const std::vector<DirectionPair> pairs_;
    ExtremeResult result_;
};

ExtremeResult refused(const ExtremeCase& extreme, const std::string& message) {
    ExtremeResult result{.refusal = message};
    if (extreme.refusal.empty())
        result.faults.push_back("refused");
    else if (message.find(extreme.refusal) == std::string::npos)
        result.faults.push_back(fmt::format("must be refused because {}", extreme.refusal));
    return result;
}

}  // namespace

ExtremeResult judge_tables(const ExtremeCase& extreme, const std::shared_ptr<const Tables>& tables,
                           const ExtremeOptions& options, std::stop_token stop) {
    ExtremeResult result = Judgement(extreme, tables, options, std::move(stop)).run();
    if (!extreme.refusal.empty())
        result.faults.push_back(fmt::format("must be refused because {}", extreme.refusal));
    return result;
}

ExtremeResult judge(const ExtremeCase& extreme, const ExtremeOptions& options, const std::stop_token& stop) {
    const Stopwatch time;
    ExtremeResult result;
    try {
        result = judge_tables(extreme, bake(extreme.design, {.albedo = true}, stop), options, stop);
    } catch (const UserError& error) {
        result = refused(extreme, fmt::format("{}: {}", error.where, error.problem));
    }
    result.seconds = time.seconds();
    return result;
}

std::vector<ExtremeResult> judge_all(std::span<const ExtremeCase> cases, const ExtremeOptions& options,
                                     std::stop_token stop, const std::function<void(double)>& progress) {
    std::vector<ExtremeResult> results(cases.size());
    std::mutex mutex;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
        results[i] = judge(cases[i], options, stop);
        const std::lock_guard lock(mutex);
        ++done;
        if (progress) progress(static_cast<double>(done) / static_cast<double>(cases.size()));
    });
    return results;
}

}  // namespace nacre
