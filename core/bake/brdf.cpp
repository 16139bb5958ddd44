#include "core/bake/brdf.h"

#include "core/bake/mirror_ways.h"
#include "core/model/visible_facets.h"

namespace nacre {

dvec3 brdf_term(const Shading<double>& shading, const Shading<double>::Direction& a,
                const Shading<double>::Direction& b, Term term) {
    switch (term) {
        case Term::specular:
            return shading.whole_specular(a, b) * shading.surface.ks;
        case Term::multibounce:
            return shading.whole_multibounce(a, b) * shading.surface.ks;
        case Term::retro:
            if (!shading.kinds.retro) return dvec3{0};
            return shading.retro_specular(a, b) * (shading.surface.retro * shading.surface.ks);
        case Term::diffuse:
            return shading.diffuse(a, b);
        case Term::density:
            return dvec3{shading.mirroring_density(a, b)};
        case Term::masking1:
            return dvec3{shading.masking(a)};
        case Term::masking2:
            return dvec3{shading.masking(b)};
        case Term::fresnel:
            return shading.mirroring_fresnel(a, b);
        case Term::inverse_areas:
            return dvec3{shading.inverse_areas(a, b)};
        case Term::total:
            break;
    }
    return shading.brdf_of(a, b);
}

dvec3 Brdf::evaluate(dvec3 k1, dvec3 k2, Term term) const {
    if (k1.z <= 0 || k2.z <= 0) return dvec3{0};
    const Shading<double>& shading = tables_->shading;
    return brdf_term(shading, shading.direction(k1), shading.direction(k2), term);
}

double Brdf::cosine_probability() const { return tables_->shading.cosine_probability(); }

double Brdf::pdf(dvec3 k1, dvec3 k2) const {
    if (k1.z <= 0 || k2.z <= 0) return 0;
    const Shading<double>& shading = tables_->shading;
    if (shading.kinds.retro) {
        const auto facets = shading.mirrored_in_all_ways(shading.direction(k1), shading.direction(k2));
        return shading.sampled_density(facets.drawn, k2.z);
    }
    const double g = shading.projected_area(k1, shading.table_spot(k1));
    const auto between = shading.half_vector(k1, k2);
    const double p = between.exists ? shading.density(between.h) : 0;
    return shading.sampled_density(shading.facet_density(g, p), k2.z);
}

dvec3 Brdf::draw(dvec3 k1, Random& random) const {
    constexpr dvec3 none{0};
    if (k1.z <= 0) return none;
    const double diffuse = cosine_probability();
    if (diffuse > 0 && uniform_random(random) < diffuse) return cosine_sample(random);
    const MirrorWay way = draw_way(tables_->shading, random);
    const dvec3 from = way.entering(k1);
    const std::optional<dvec3> h = tables_->distribution->visible_facets()(from, random);
    return h ? way.leaving(mirrored(from, *h)) : none;
}

std::optional<BrdfSample> Brdf::sample(dvec3 k1, Random& random) const {
    if (k1.z <= 0) return {};
    return BrdfSampler(*this, k1)(random);
}

BrdfSampler::BrdfSampler(const Brdf& brdf, dvec3 k1)
    : brdf_(brdf), from_(brdf.tables().shading.direction(k1.z > 0 ? k1 : dvec3{0, 0, 1})) {
    from_.k = k1;
}

std::optional<BrdfSample> BrdfSampler::operator()(Random& random) const {
    const dvec3 k2 = brdf_.draw(from_.k, random);
    if (!(k2.z > 0)) return {};
    const Shading<double>& shading = brdf_.tables().shading;
    dvec3 rho;
    double density;
    shading.brdf_and_density(from_, shading.direction(k2), rho, density);
    if (!(density > 0)) return {};
    return BrdfSample{k2, rho * (k2.z / density), density};
}

dvec3 Brdf::albedo(dvec3 k) const {
    const Shading<double>& shading = tables_->shading;
    if (!shading.kinds.albedo || k.z < 0) return dvec3{0};
    return shading.direction(k).R;
}

dvec3 Brdf::total_albedo(dvec3 k) const {
    const Shading<double>& shading = tables_->shading;
    if (!shading.kinds.albedo || k.z < 0) return dvec3{0};
    return shading.total_albedo(shading.direction(k));
}

}  // namespace nacre
