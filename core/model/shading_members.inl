// The members of core/model/shading.h's Shading and of lane_shading-inl.h's LaneShading: the shader's own text. The struct
// around it supplies `scalar`, `real`, `integer` and `condition` (see shaders/shared/parameters.glsl), vectors
// of them, and fetch().

#define CONSTANT static constexpr
#define PURE static
#define READS const
#define HAS_GAUSSIAN 1
#define HAS_GGX 1
#define HAS_BECKMANN 1
#define HAS_PICTURE 1
#define HAS_MODULATION 1
#define HAS_ALBEDO 1
#define HAS_LINEAR_FRESNEL 1
#define HAS_EXACT_FRESNEL 1
#define FRESNEL_IS(index) kinds.fresnel == index
#define FRESNEL_IS_LINEAR kinds.fresnel_tables() == FresnelTables::linear
#define FRESNEL_IS_EXACT kinds.fresnel_tables() == FresnelTables::exact
#define MASKING_IS(index) kinds.masking == index
#define DIFFUSE_IS(index) kinds.diffuse == index
#define CLAMP_VISIBILITY kinds.clamp
#define READS_ALBEDO kinds.albedo
#define HAS_TINT 1
#define HAS_MULTIBOUNCE 1
#define BOUNCES kinds.bounces()
#define BOUNCE_FACTORS kinds.bounce_factors()
#define MULTIBOUNCE_IS(index) kinds.multibounce == index
#define TINTED (kinds.tint != Tint::none)
#define TINT_VARIES (kinds.tint == Tint::varied)
#define HAS_MATT_FACETS 1
#define HAS_RETRO 1
#define IS_RETRO kinds.retro
#define HAS_COAT 1
#define IS_COATED kinds.coated()
#define COAT_IS(index) kinds.coat == index
#define OR_ZERO {}

static constexpr scalar LARGEST = std::numeric_limits<scalar>::max();

#include "shaders/shared/parameters.glsl"

// The specular term alone.
static Surface plain_surface() {
    Surface plain{};
    plain.ks = 1;
    return plain;
}

ShadingKinds kinds;
Surface surface = plain_surface();
Layer layers[limits::layers_max]{};
int layer_count = 0;
const float* data = nullptr;  // tables, curves and pictures; owned by the Tables this was made from
const float* curve = nullptr;  // F, where it is a table; owned by fresnel_curve of the Shading<double> this was made from

// A kind need not look at all that its function is given.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "shaders/shared/fresnel.glsl"
#include "shaders/shared/fresnel_curve.glsl"
#include "core/model/fresnel_members.inl"
#include "shaders/shared/pictures.glsl"
#include "core/model/lobes_members.inl"
#include "shaders/shared/lobes.glsl"
#include "shaders/shared/tables.glsl"
#include "shaders/shared/direction.glsl"
#include "shaders/shared/retro.glsl"
#include "core/model/masking_members.inl"
#include "shaders/shared/visibility.glsl"
#include "shaders/shared/matt_facets.glsl"
#include "core/model/diffuse_members.inl"
#include "shaders/shared/bounce_tables.glsl"
#include "core/model/multibounce_members.inl"
#include "core/model/coat_members.inl"
#pragma GCC diagnostic pop
#include "shaders/shared/multibounce.glsl"
#include "shaders/shared/coat.glsl"
#include "shaders/shared/brdf.glsl"
#include "shaders/shared/terms.glsl"
#include "shaders/shared/closed_forms.glsl"

// The integrand of R(k1) over facets, tints left out, F = 1 and then each of `channels` (0, 1 or 3) Fresnel factors: with
// dk2 = 4 (k1.h) dh a facet of mass p dh adds F (k1.h) V(k1, k2) c2 of it, V = P12/(N c1 c2). `area` gives g(k2).
template <class AreaOf>
void facet_albedo(const Direction& a, real3 h, int channels, const AreaOf& area, real (&values)[4]) const {
    const real kh = dot(a.k, h);
    const real3 mirrored = h * (real(2.0) * kh) - a.k;
    const condition up = kh > real(0.0) && mirrored.z > real(0.0);
    for (real& value : values) value = real(0.0);
    if (none(up)) return;
    Direction b;
    b.k = select(up, mirrored, real3(0.0, 0.0, 1.0));
    b.g = area(b.k);
    values[0] = select(up, kh * b.k.z * visibility(a, b), real(0.0));
    weigh_by_fresnel(min(kh, real(1.0)), channels, values);
}

// The same of the light that does not leave after one bounce: of P1 what P12 leaves. A facet adds F (k1.h)(1/G1 - V c2).
template <class AreaOf>
void facet_bounce(const Direction& a, real3 h, int channels, const AreaOf& area, real (&values)[4]) const {
    const real kh = dot(a.k, h);
    const condition seen = kh > real(0.0);
    for (real& value : values) value = real(0.0);
    if (none(seen)) return;
    facet_albedo(a, h, 0, area, values);
    const real G = CLAMP_VISIBILITY ? max(a.g, surface.N * a.k.z) : a.g;
    values[0] = select(seen, max(safe_divide(kh, G) - values[0], real(0.0)), real(0.0));
    weigh_by_fresnel(min(max(kh, real(0.0)), real(1.0)), channels, values);
}

// values[0] times each Fresnel factor of a facet that is seen at `cosine`.
void weigh_by_fresnel(real cosine, int channels, real (&values)[4]) const {
    if (channels == 1) values[1] = values[0] * schlick_weight(cosine);
    if (channels == 3) {
        const real3 f = fresnel(cosine);
        values[1] = values[0] * f.x;
        values[2] = values[0] * f.y;
        values[3] = values[0] * f.z;
    }
}

// How often Brdf::sample() draws the cosine about n instead of a facet.
scalar cosine_probability() const {
    if (kinds.diffuse != kind_index<Diffuse, NoDiffuse>()) return scalar(0.5);
    return kinds.bounces() || kinds.coated() ? scalar(0.25) : scalar(0);
}

// What is known of k without tables.
static Direction known_direction(real3 k, real g, real3 R) {
    Direction a{};
    a.k = k;
    a.g = g;
    a.R = R;
    return a;
}

// How densely visible facets send k1 into k2, 1/sr; p that of those which mirror one into the other.
static real facet_density(real g1, real p) {
    return select(g1 > real(0.0), p / (real(4.0) * g1), real(0.0));
}

// The density of k2 in Brdf::sample(), 1/sr; `facets` that of the specular term, c2 its cosine.
real sampled_density(real facets, real c2) const {
    const real part = cosine_probability();
    return (real(1.0) - part) * facets + part * (c2 / real(TABLE_PI));
}

// The specular term and that density of its samples, from one look at p.
struct Mirrored {
    real3 rho;
    real drawn;
};

Mirrored mirrored(const Direction& a, const Direction& b) const {
    const HalfVector between = half_vector(a.k, b.k);
    const real p = select(between.exists, density(between.h), real(0.0));
    return {specular_of(a, b, between, p), facet_density(a.g, p)};
}

// The same of a retro-reflective design, whose samples are drawn in all its ways.
Mirrored mirrored_in_all_ways(const Direction& a, const Direction& b) const {
    const Mirrored plain = mirrored(a, b), before = mirrored(turned(a), b), after = mirrored(a, turned(b));
    const real half(0.5), part(surface.retro);
    return {retro_mixed(plain.rho, before.rho * half + after.rho * half),
            (real(1.0) - part) * plain.drawn + part * (half * before.drawn + half * after.drawn)};
}

// How often Brdf::sample() draws one of the coat's own facets: as much of the light as they mirror.
real coat_probability(const Direction& a) const {
    const real3 through = a.passed * a.whole;
    const real beneath = (through.x + through.y + through.z) / real(3.0), all = a.coat_R + beneath;
    const real part = select(all > real(0.0), a.coat_R / all, real(0.5));
    return min(max(part, real(0.1)), real(0.9));
}

// The density of k2 in Brdf::sample() of a coated design; `facets` that of k2 inside, by the facets beneath.
real coated_density(const Direction& a, const Direction& b, real facets) const {
    const HalfVector between = half_vector(a.outside, b.outside);
    const real mirrored = facet_density(a.coat_g, select(between.exists, coat_density(between.h.z), real(0.0)));
    const scalar square = surface.coat_ior * surface.coat_ior;
    const real beneath = sampled_density(facets * b.outside.z / (b.k.z * real(square)), b.outside.z);
    const real part = coat_probability(a);
    return part * mirrored + (real(1.0) - part) * beneath;
}

// coated_brdf_of(), and the density of k2 in Brdf::sample().
void brdf_and_density(const Direction& a, const Direction& b, real3& rho, real& drawn) const {
    const Mirrored facets = kinds.retro ? mirrored_in_all_ways(a, b) : mirrored(a, b);
    rho = facets.rho;
    if (kinds.bounces()) rho += whole_multibounce(a, b);
    rho = rho * surface.ks + diffuse(a, b);
    if (!kinds.coated()) {
        drawn = sampled_density(facets.drawn, b.k.z);
        return;
    }
    rho = coat_reflection(a, b) + coat_passage(a, b) * rho;
    drawn = coated_density(a, b, facets.drawn);
}

#undef CONSTANT
#undef PURE
#undef READS
#undef HAS_GAUSSIAN
#undef HAS_GGX
#undef HAS_BECKMANN
#undef HAS_PICTURE
#undef HAS_MODULATION
#undef HAS_ALBEDO
#undef HAS_LINEAR_FRESNEL
#undef HAS_EXACT_FRESNEL
#undef FRESNEL_IS
#undef FRESNEL_IS_LINEAR
#undef FRESNEL_IS_EXACT
#undef MASKING_IS
#undef DIFFUSE_IS
#undef CLAMP_VISIBILITY
#undef READS_ALBEDO
#undef HAS_TINT
#undef HAS_MULTIBOUNCE
#undef BOUNCES
#undef BOUNCE_FACTORS
#undef MULTIBOUNCE_IS
#undef TINTED
#undef TINT_VARIES
#undef HAS_MATT_FACETS
#undef HAS_RETRO
#undef IS_RETRO
#undef HAS_COAT
#undef IS_COATED
#undef COAT_IS
#undef OR_ZERO
#undef EACH_LOBE
#undef EACH_FRESNEL
#undef EACH_MASKING
#undef EACH_DIFFUSE
#undef EACH_MULTIBOUNCE
#undef EACH_COAT
