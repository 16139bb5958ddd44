// The members of core/model/shading.h's Shading and of lane_shading-inl.h's LaneShading: the shader's own text. The struct
// around it supplies `scalar`, `real`, `integer` and `condition` (see shaders/shared/parameters.glsl), vectors
// of them, and fetch().

#define CONSTANT static constexpr
#define PURE static
#define READS const
#define HAS_GAUSSIAN 1
#define HAS_INVERSE_GAUSSIAN 1
#define HAS_GGX 1
#define HAS_BECKMANN 1
#define HAS_UNIFORM 1
#define HAS_CURVE 1
#define HAS_PAINTED 1
#define HAS_MODULATION 1
#define HAS_ALBEDO 1
#define FRESNEL_SCHLICK 1
#define FRESNEL_DIELECTRIC 1
#define FRESNEL_CONDUCTOR 1
#define VISIBILITY_CORRELATED 1
#define VISIBILITY_SMITH 1
#define DIFFUSE_LAMBERTIAN 1
#define DIFFUSE_COUPLED 1
#define DIFFUSE_METAL 1
#define FRESNEL_IS_SCHLICK kinds.fresnel == FresnelKind::schlick
#define FRESNEL_IS_DIELECTRIC kinds.fresnel == FresnelKind::dielectric
#define FRESNEL_IS_CONDUCTOR kinds.fresnel == FresnelKind::conductor
#define VISIBILITY_IS_CORRELATED kinds.visibility == VisibilityKind::correlated
#define VISIBILITY_IS_SMITH kinds.visibility == VisibilityKind::smith_correlated
#define CLAMP_VISIBILITY kinds.clamp
#define DIFFUSE_IS_LAMBERTIAN kinds.diffuse == DiffuseKind::lambertian
#define DIFFUSE_IS_COUPLED kinds.diffuse == DiffuseKind::coupled
#define DIFFUSE_IS_METAL kinds.diffuse == DiffuseKind::metal
#define READS_ALBEDO kinds.albedo

static constexpr scalar LARGEST = std::numeric_limits<scalar>::max();

#include "shaders/shared/parameters.glsl"

ShadingKinds kinds;
Surface surface{};
Layer layers[limits::layers_max]{};
int layer_count = 0;
const float* data = nullptr;  // tables, curves and pictures; owned by the Tables this was made from

#include "shaders/shared/fresnel.glsl"
#include "shaders/shared/lobes.glsl"
#include "shaders/shared/tables.glsl"

#include "shaders/shared/brdf.glsl"
#include "shaders/shared/terms.glsl"
#include "shaders/shared/closed_forms.glsl"

// The integrand of R(k1) over facets, F = 1 and then each of `channels` (0, 1 or 3) Fresnel factors: with
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
    b.R = real3(0.0);
    values[0] = select(up, kh * b.k.z * visibility(a, b), real(0.0));
    const real cosine = min(kh, real(1.0));
    if (channels == 1) values[1] = values[0] * schlick_weight(cosine);
    if (channels == 3) {
        const real3 f = fresnel(cosine);
        values[1] = values[0] * f.x;
        values[2] = values[0] * f.y;
        values[3] = values[0] * f.z;
    }
}

#undef CONSTANT
#undef PURE
#undef READS
#undef HAS_GAUSSIAN
#undef HAS_INVERSE_GAUSSIAN
#undef HAS_GGX
#undef HAS_BECKMANN
#undef HAS_UNIFORM
#undef HAS_CURVE
#undef HAS_PAINTED
#undef HAS_MODULATION
#undef HAS_ALBEDO
#undef FRESNEL_SCHLICK
#undef FRESNEL_DIELECTRIC
#undef FRESNEL_CONDUCTOR
#undef VISIBILITY_CORRELATED
#undef VISIBILITY_SMITH
#undef DIFFUSE_LAMBERTIAN
#undef DIFFUSE_COUPLED
#undef DIFFUSE_METAL
#undef FRESNEL_IS_SCHLICK
#undef FRESNEL_IS_DIELECTRIC
#undef FRESNEL_IS_CONDUCTOR
#undef VISIBILITY_IS_CORRELATED
#undef VISIBILITY_IS_SMITH
#undef CLAMP_VISIBILITY
#undef DIFFUSE_IS_LAMBERTIAN
#undef DIFFUSE_IS_COUPLED
#undef DIFFUSE_IS_METAL
#undef READS_ALBEDO
