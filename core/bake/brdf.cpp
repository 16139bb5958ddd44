#include "core/bake/brdf.h"

#include "core/bake/mirror_ways.h"
#include "core/model/visible_facets.h"

namespace nacre {

namespace {

// As the facets send it, beneath a coat if there is one.
dvec3 facet_term(const Shading<double>& shading, const Shading<double>::Direction& a,
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
        case Term::coat:
        case Term::total:
            break;
    }
    return shading.brdf_of(a, b);
}

}  // namespace

dvec3 brdf_term(const Shading<double>& shading, const Shading<double>::Direction& a,
                const Shading<double>::Direction& b, Term term) {
    const bool coated = shading.kinds.coated();
    if (term == Term::coat) return coated ? shading.coat_reflection(a, b) : dvec3{0};
    if (term == Term::total) return shading.coated_brdf_of(a, b);
    const dvec3 value = facet_term(shading, a, b, term);
    return coated && !is_factor(term) ? shading.coat_passage(a, b) * value : value;
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
    if (shading.kinds.coated()) {
        dvec3 rho;
        double density;
        shading.brdf_and_density(shading.direction(k1), shading.direction(k2), rho, density);
        return density;
    }
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
    const Shading<double>& shading = tables_->shading;
    if (shading.kinds.coated()) return draw_coated(shading.direction(k1), random);
    const double diffuse = cosine_probability();
    if (diffuse > 0 && uniform_random(random) < diffuse) return cosine_sample(random);
    return draw_facet(k1, random);
}

// k2 from a facet beneath the coat, if there is one: both directions are inside.
dvec3 Brdf::draw_facet(dvec3 k1, Random& random) const {
    const MirrorWay way = draw_way(tables_->shading, random);
    const dvec3 from = way.entering(k1);
    const std::optional<dvec3> h = tables_->distribution->visible_facets()(from, random);
    return h ? way.leaving(mirrored(from, *h)) : dvec3{0};
}

dvec3 Brdf::draw_coated(const Shading<double>::Direction& from, Random& random) const {
    const Shading<double>& shading = tables_->shading;
    if (uniform_random(random) < shading.coat_probability(from)) {
        const std::optional<dvec3> h = tables_->coat_facets->visible_facets()(from.outside, random);
        return h ? mirrored(from.outside, *h) : dvec3{0};
    }
    if (uniform_random(random) < cosine_probability()) return cosine_sample(random);
    const dvec3 inside = draw_facet(from.k, random);
    return inside.z > 0 ? shading.emerging(inside) : dvec3{0};
}

std::optional<BrdfSample> Brdf::sample(dvec3 k1, Random& random) const {
    if (k1.z <= 0) return {};
    return BrdfSampler(*this, k1)(random);
}

BrdfSampler::BrdfSampler(const Brdf& brdf, dvec3 k1)
    : brdf_(brdf), k1_(k1), from_(brdf.tables().shading.direction(k1.z > 0 ? k1 : dvec3{0, 0, 1})) {}

std::optional<BrdfSample> BrdfSampler::operator()(Random& random) const {
    if (!(k1_.z > 0)) return {};
    const dvec3 k2 =
        brdf_.tables().shading.kinds.coated() ? brdf_.draw_coated(from_, random) : brdf_.draw(k1_, random);
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
    return shading.coated_albedo(shading.direction(k));
}

}  // namespace nacre
