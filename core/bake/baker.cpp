#include "core/bake/baker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bake/coupling.h"
#include "core/bake/table_fits.h"
#include "core/base/stopwatch.h"
#include "core/model/merged_facets.h"
#include "core/model/picture_lobe.h"
#include "core/shading/surface.h"

namespace nacre {
namespace {

// Of eq. 28's constant, between two rows of R.
constexpr double final_coupling = 1e-7, draft_coupling = 1e-4;

// A draft's grid is refitted when the error of g has grown by this factor since.
constexpr double outgrown = 2, outgrown_min = 5e-3;

// Names and tints are not facets.
Distribution facets_alone(Distribution distribution) {
    for (Layer& layer : distribution.layers) {
        layer.name.clear();
        layer.tint = dvec3{1};
    }
    return distribution;
}

bool same_place(const Layer& a, const Layer& b) {
    return a.tilt == b.tilt && a.azimuth == b.azimuth && a.rotation == b.rotation;
}

bool same_lobe(const Layer& a, const Layer& b) { return a.lobe == b.lobe && a.modulation == b.modulation; }

// Everything that the table of g and its measured error depend on.
bool same_area(const Design& a, const Design& b) {
    return facets_alone(a.distribution) == facets_alone(b.distribution) &&
           a.shadowing.clamp == b.shadowing.clamp;
}

// A tint that all layers share is not in the tables of R.
bool same_tints(const Distribution& a, const Distribution& b) {
    const bool varied = tint_of(a) == Tint::varied;
    if (varied != (tint_of(b) == Tint::varied)) return false;
    return !varied || std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(),
                                 [](const Layer& one, const Layer& other) { return one.tint == other.tint; });
}

// Everything that the tables of R depend on, given the same g.
bool same_albedo(const Design& a, const Design& b) {
    const bool linear = fresnel_tables(a.fresnel) == FresnelTables::linear &&
                        fresnel_tables(b.fresnel) == FresnelTables::linear;
    const bool same_fresnel = a.fresnel == b.fresnel && index_above(a.coat) == index_above(b.coat);
    return a.shadowing == b.shadowing && (linear || same_fresnel) &&
           same_tints(a.distribution, b.distribution);
}

// Whether tables are fitted to random walks.
bool fits_bounces(const Design& design, const BakeOptions& options) {
    return is_fitted(design.multibounce) && options.fit_bounces && options.quality == Quality::final;
}

bool same_wishes(const BakeOptions& a, const BakeOptions& b) {
    return a.quality == b.quality && a.tolerance == b.tolerance && a.size == b.size &&
           a.symmetry == b.symmetry;
}

}  // namespace

// The lobe of a layer in the p before; null where it has none.
const PlacedLobe* Baker::lobe_before(std::size_t layer) const {
    if (!distribution_) return nullptr;
    const auto& lobes = distribution_->lobes();
    const auto found = std::ranges::find(lobes, layer, &PlacedLobe::layer);
    return found == lobes.end() ? nullptr : &*found;
}

// With the lobes before where they are the same but for a touch of the brush.
std::shared_ptr<const FacetDistribution> Baker::make(const Distribution& distribution) const {
    return std::make_shared<const FacetDistribution>(
        distribution, [&](const Layer& layer, std::size_t index) -> std::shared_ptr<const LobeModel> {
            if (const PlacedLobe* before = lobe_before(index)) {
                if (same_lobe(layer, before_.layers[index])) return before->lobe;
                if (auto touched = repaint(*before->lobe, layer)) return touched;
            }
            return make_lobe(layer);
        });
}

// `p`: of the distribution, or null.
Baker::Followed Baker::follow(const Distribution& distribution,
                              std::shared_ptr<const FacetDistribution> p) const {
    Followed now;
    if (distribution_ && before_ == distribution) {
        now.distribution = distribution_;
        now.changes.resize(distribution_->lobes().size());
        now.same_lobes = true;
        return now;
    }
    now.distribution = p ? std::move(p) : make(distribution);
    const auto& lobes = now.distribution->lobes();
    now.changes.resize(lobes.size());
    now.same_lobes = distribution_ && lobes.size() == distribution_->lobes().size();
    for (std::size_t i = 0; i < lobes.size() && now.same_lobes; ++i) {
        const std::size_t index = lobes[i].layer;
        const PlacedLobe* const before = lobe_before(index);
        now.same_lobes = before && same_place(distribution.layers[index], before_.layers[index]);
        if (!now.same_lobes || same_lobe(distribution.layers[index], before_.layers[index])) continue;
        auto painted = painted_between(*before->lobe, *lobes[i].lobe);
        now.same_lobes = painted.has_value();
        if (painted) now.changes[i] = std::move(*painted);
    }
    return now;
}

std::optional<Baker::KeptArea> Baker::sum_area(const Kept& made, const Followed& now,
                                               const Shading<double>& material, Workers& workers) const {
    if (made.options.quality != Quality::draft || !draft_ || !now.same_lobes || made.options.size ||
        draft_->area.table->distribution() != distribution_ || draft_->needs.symmetry != made.needs.symmetry)
        return {};
    KeptArea area = draft_->area;
    area.tried.clear();
    area.table = std::make_shared<const AreaTable>(*area.table, now.distribution, now.changes, workers);
    area.error = area.table->measure(material);
    if (area.error.all.worst > std::max(outgrown * area.fitted_error, outgrown_min)) return {};
    return area;
}

Baker::KeptArea Baker::make_area(const Kept& made, const Followed& now, const Shading<double>& material,
                                 Workers& workers) {
    area_origin_ = TableOrigin::updated;
    if (auto summed = sum_area(made, now, material, workers)) return std::move(*summed);
    area_origin_ = TableOrigin::rebuilt;
    // Merged facets have no layers, whose tints R would need.
    const bool many = made.options.quality == Quality::final && made.needs.tint != Tint::varied &&
                      count_facets(made.design.distribution) > many_facets;
    const std::shared_ptr<const FacetDistribution> tabled =
        many ? workers.run([&] { return merge_facets(made.design.distribution, *now.distribution); })
             : now.distribution;
    FittedArea fitted = fit_area(tabled, made.needs, made.options, material, workers);
    KeptArea area{.table = std::move(fitted.table),
                  .nodes = fitted.nodes,
                  .error = fitted.error,
                  .fitted_error = fitted.error.all.worst,
                  .tried = std::move(fitted.tried)};
    if (many) {
        const double merging = workers.run([&] { return merging_error(*now.distribution, *tabled); });
        area.error.all.worst += merging;
        area.error.all.root_mean_square += merging;
    }
    return area;
}

Baker::KeptAlbedo Baker::make_albedo(const Kept& made, const Shading<double>& material, Workers& workers) {
    FittedAlbedo fitted =
        fit_albedo(*made.area.table, made.area.error, made.needs, made.options, material, workers);
    return {.data = std::make_shared<const std::vector<float>>(std::move(fitted.data)),
            .nodes = fitted.nodes,
            .error = fitted.error,
            .tried = std::move(fitted.tried)};
}

// Keeps of the tables before what the design does not change.
void Baker::choose_tables(Kept& made, const std::optional<Kept>& before, const Followed& now,
                          const Shading<double>& material, Workers& workers) {
    const bool keep_area = before && same_wishes(before->options, made.options) &&
                           same_area(before->design, made.design) &&
                           before->needs.symmetry == made.needs.symmetry;
    const bool keep_albedo = keep_area && before->albedo.data && same_albedo(before->design, made.design);
    if (keep_albedo && before->bounces &&
        fits_bounces(made.design, made.options) == before->bounces->momentum.has_value())
        made.bounces = before->bounces;
    if (keep_area && before->design.shadowing == made.design.shadowing) made.facets = before->facets;
    if (before) made.coat = before->coat;
    area_origin_ = albedo_origin_ = TableOrigin::reused;
    made.distribution = keep_area ? before->distribution : now.distribution;
    if (keep_area) {
        made.area = before->area;
    } else {
        const Stopwatch time;
        made.area = make_area(made, now, material, workers);
        made.area.seconds = time.seconds();
    }
    if (keep_albedo) {
        made.albedo = before->albedo;
    } else if (made.needs.albedo) {
        const Stopwatch time;
        made.albedo = make_albedo(made, material, workers);
        made.albedo.seconds = time.seconds();
        albedo_origin_ = TableOrigin::rebuilt;
    }
}

std::shared_ptr<const Tables> Baker::bake(const Design& named, const BakeOptions& options,
                                          std::stop_token stop, const std::function<void(double)>& progress,
                                          std::shared_ptr<const FacetDistribution> p) {
    const Stopwatch time;
    Workers workers(options.threads, std::move(stop));
    auto report = [&](double done) {
        workers.check();
        if (progress) progress(done);
    };
    report(0);
    Kept made{.design = named, .options = options};
    made.needs = needs_of(named, {options.albedo, options.symmetry});
    const Distribution facets = facets_alone(named.distribution);
    const Followed now = workers.run([&] { return follow(facets, std::move(p)); });
    report(0.1);
    auto tables = std::make_shared<Tables>();
    describe_material(named, *now.distribution, tables->shading);
    tables->shading.kinds.albedo = made.needs.albedo;
    std::optional<Kept>& slot = options.quality == Quality::draft ? draft_ : final_;
    choose_tables(made, slot, now, tables->shading, workers);
    report(0.9);
    assemble(made, *tables, workers);
    before_ = facets;
    distribution_ = made.distribution;
    slot = std::move(made);
    tables->seconds = time.seconds();
    report(1);
    return tables;
}

void Baker::add_albedo(const Kept& made, Tables& tables) {
    const KeptAlbedo& albedo = made.albedo;
    AlbedoTable::place(tables.shading, albedo.nodes, static_cast<int>(tables.data.size()));
    tables.data.insert(tables.data.end(), albedo.data->begin(), albedo.data->end());
    // An error of g is one of P in R = E[F P], so that it adds at most its mean.
    tables.errors.albedo = albedo.error;
    tables.errors.albedo.worst += tables.errors.area.root_mean_square;
    tables.errors.albedo.root_mean_square += tables.errors.area.root_mean_square;
    tables.tried_albedo = albedo.tried;
    tables.size.v = albedo.nodes.polar;
    tables.size.rho = albedo.nodes.azimuth;
}

void Baker::integrate(const Kept& made, Tables& tables, Workers& workers) {
    const AlbedoIntegrals integrals = integrate_albedo(
        tables.shading, made.options.quality == Quality::draft ? draft_coupling : final_coupling, workers);
    tables.mean_albedo = integrals.mean;
    tables.shading.surface.coupling = integrals.coupling;
}

void Baker::assemble(Kept& made, Tables& tables, Workers& workers) {
    Shading<double>& shading = tables.shading;
    shading = made.area.table->shading(shading);
    tables.needs = made.needs;
    tables.omissions = omissions_of(made.design, made.needs);
    tables.quality = made.options.quality;
    tables.intensity = made.design.specular.intensity;
    tables.size.w = made.area.nodes.polar;
    tables.size.psi = made.area.nodes.azimuth;
    tables.distribution = made.distribution;
    tables.mean = tables.distribution->mean();
    tables.data = made.area.table->data();
    tables.tolerance = made.options.tolerance;
    tables.bake_seconds = made.area.seconds + made.albedo.seconds;
    tables.errors.area = made.area.error.all;
    tables.tried_area = made.area.tried;
    if (made.albedo.data) add_albedo(made, tables);
    append_fresnel_curve(shading, tables.data);
    describe_layers(made.design.distribution, *tables.distribution, shading, tables.data);
    shading.data = tables.data.data();
    if (has_bounces(made.design.multibounce))
        add_bounce_tables(tables, made.area.table->grid(), made.design.multibounce,
                          fits_bounces(made.design, made.options), made.bounces, workers);
    if (has_matt_facets(made.design.diffuse))
        add_facet_tables(tables, made.area.table->grid(), made.facets, workers);
    if (made.albedo.data) integrate(made, tables, workers);
    if (is_coated(made.design.coat))
        add_coat_tables(tables, made.area.table->grid(), made.design.coat, made.coat, workers);
}

}  // namespace nacre
