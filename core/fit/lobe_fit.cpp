#include "core/fit/lobe_fit.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/fit/lobe_em.h"
#include "core/fit/lobe_refine.h"

namespace nacre {

namespace {

constexpr int fitted_pairs = 60000, unseen_pairs = 20000, facet_count = 9000;
constexpr double bad = 0.1;  // of the misplaced energy: what a picture shows at once

// What both kinds of weight are fitted to.
struct Goal {
    std::vector<FitPair> pairs, unseen;
    std::vector<LobeFrame> start;
    ViewMask mask;
};

void check(const FitSettings& settings) {
    if (settings.lobes < 1 || settings.lobes > fit_lobes_max)
        throw UserError("", "lobes", fmt::format("must be from 1 to {}", fit_lobes_max),
                        std::to_string(settings.lobes));
    if (settings.target == FitTarget::standard && settings.weights == LobeWeights::view)
        throw UserError("", "weights", "the standard target has lobes of constant weight only", "view");
}

std::vector<float> tile_of(const ViewedLobe& model, const LobeFrame& lobe, const ViewMask& mask) {
    std::vector<float> tile;
    for (int row = 0; row < tile_side; ++row)
        for (int column = 0; column < tile_side; ++column) {
            const dvec3 v = texel_direction(column, row, tile_side);
            tile.push_back(static_cast<float>(model.view_weight(lobe, v, mask.part(v))));
        }
    return tile;
}

// The heaviest lobe first.
LobeMixture stored(const ViewedLobe& model, const std::vector<LobeFrame>& lobes, const ViewMask& mask) {
    LobeMixture mixture{model.shape(), model.weights(), {}};
    for (const LobeFrame& lobe : lobes) {
        mixture.lobes.push_back(lobe_of(lobe));
        if (model.weights() == LobeWeights::view) mixture.lobes.back().tile = tile_of(model, lobe, mask);
    }
    std::stable_sort(mixture.lobes.begin(), mixture.lobes.end(),
                     [](const MixtureLobe& a, const MixtureLobe& b) { return a.weight > b.weight; });
    return mixture;
}

// The mixture of one kind of weight, and how near it is on the pairs of the fit.
struct Candidate {
    LobeMixture mixture;
    double seen;
};

Candidate fit_weights(const Goal& goal, LobeWeights weights, const FitSettings& settings, Workers& workers,
                      const std::function<void(double)>& progress) {
    const ViewedLobe model(settings.shape, weights, goal.mask);
    std::vector<LobeFrame> start = goal.start;
    reweigh(model, goal.pairs, start, workers);
    const RefineSettings refinement{
        .steps = settings.steps, .tilted = settings.target == FitTarget::cycles, .seed = settings.seed + 3};
    std::vector<LobeFrame> lobes = refine(model, goal.pairs, start, refinement, workers, progress);
    double seen = misplaced_energy(model, lobes, goal.pairs);
    const double before = misplaced_energy(model, start, goal.pairs);
    if (!(seen <= before)) {
        lobes = std::move(start);
        seen = before;
    }
    return {stored(model, lobes, goal.mask), seen};
}

}  // namespace

LobeFit fit_lobes(const Tables& tables, const FitSettings& settings, std::stop_token stop,
                  const std::function<void(double)>& progress) {
    check(settings);
    Workers workers(settings.threads, std::move(stop));
    const auto report = [&](double done) {
        if (progress) progress(done);
    };
    const bool tilted = settings.target == FitTarget::cycles;
    Goal goal{draw_fit_pairs(tables, fitted_pairs, settings.seed),
              draw_fit_pairs(tables, unseen_pairs, settings.seed + 1),
              {},
              ViewMask(tables)};
    workers.check();
    report(0.05);
    const std::vector<dvec3> facets = draw_fit_facets(tables, facet_count, settings.seed + 2);
    if (facets.empty()) throw UserError("", "fit", "the design has no facets that face up");
    goal.start = em_lobes(facets, settings.shape, settings.lobes, tilted, settings.seed, workers);
    report(0.15);

    std::vector<LobeWeights> kinds = {LobeWeights::constant, LobeWeights::view};
    if (settings.weights) kinds = {*settings.weights};
    if (!tilted) kinds = {LobeWeights::constant};
    LobeFit fit{settings.target, {}, 0, {}};
    double best = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const double part = 0.85 / static_cast<double>(kinds.size());
        Candidate candidate = fit_weights(goal, kinds[i], settings, workers, [&](double done) {
            report(0.15 + part * (static_cast<double>(i) + done));
        });
        const double energy = misplaced_energy(candidate.mixture, goal.unseen);
        fit.tried.push_back({kinds[i], energy});
        if (i > 0 && candidate.seen >= best) continue;
        best = candidate.seen;
        fit.mixture = std::move(candidate.mixture);
        fit.misplaced = energy;
    }
    return fit;
}

std::vector<std::string> fit_notes(const LobeFit& fit, const Tables& tables) {
    std::vector<std::string> notes;
    if (tables.shading.kinds.retro)
        notes.emplace_back(
            "The lobes stand for what the facets mirror; what the design sends back is left out.");
    if (fit.misplaced <= bad) return notes;
    notes.emplace_back(fmt::format("The lobes send {:.0f} % of the light elsewhere: the picture will differ.",
                                   100 * fit.misplaced));
    if (fit.mixture.shape == LobeShape::ggx)
        notes.emplace_back(
            "No number of GGX lobes makes tails lighter than GGX's own; Beckmann lobes have light tails.");
    if (fit.target == FitTarget::standard)
        notes.emplace_back(
            "Lobes about the surface normal cannot have a painted shape, however many there are; tilted "
            "lobes "
            "or the design's own tables can.");
    else if (fit.mixture.weights == LobeWeights::constant)
        notes.emplace_back(
            "Lobes of constant weight mask themselves and not as the design does, which more lobes do not "
            "mend; weights that follow the view do.");
    else if (fit.mixture.lobes.size() < std::size_t{fit_lobes_max})
        notes.emplace_back(
            fmt::format("More lobes come nearer, up to the {} that Cycles allows.", fit_lobes_max));
    else
        notes.emplace_back(
            "Cycles allows no more lobes: what is sharper than these needs the design's own tables.");
    return notes;
}

}  // namespace nacre
