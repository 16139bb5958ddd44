// What of a surface the picture shows: its BRDF, one term of it, or a model of the same width in its place. A scene lights
// shown_brdf() and shown_albedo(); where SHOWS_FACTOR is on it shows factor() of the main light by itself.

#if CLOSED_FORM
uniform ClosedForm closed_form;
#endif

vec3 shown_specular(Direction a, Direction b) {
#if CLOSED_FORM
    return closed_form_specular(closed_form, a.k, b.k);
#else
#if HAS_RETRO
    if (IS_RETRO) return whole_specular(a, b) * surface.ks;
#endif
    return specular(a, b) * surface.ks;
#endif
}

vec3 shown_diffuse(Direction a, Direction b) {
#if CLOSED_FORM
    return closed_form_diffuse(closed_form, a, b);
#else
    return diffuse(a, b);
#endif
}

#if HAS_MULTIBOUNCE
// A closed form knows of none.
vec3 shown_bounces(Direction a, Direction b) {
#if CLOSED_FORM
    return vec3(0.0);
#else
    return whole_multibounce(a, b) * surface.ks;
#endif
}

vec3 shown_bounce_albedo(Direction a) {
#if CLOSED_FORM
    return vec3(0.0);
#else
    return a.M * surface.ks;
#endif
}
#endif

#if SHOWS_RETRO
// Black where the design has none, or a model stands in its place.
vec3 shown_retro(Direction a, Direction b) {
    vec3 rho = vec3(0.0);
#if HAS_RETRO
#if !CLOSED_FORM
    rho = retro_specular(a, b) * (surface.retro * surface.ks);
#endif
#endif
    return rho;
}

vec3 shown_retro_albedo(Direction a) {
    vec3 albedo = vec3(0.0);
#if HAS_RETRO
#if !CLOSED_FORM
    albedo = a.retro_R * (surface.retro * surface.ks);
#endif
#endif
    return albedo;
}

#endif
// 1/sr
vec3 shown_brdf(Direction a, Direction b) {
#if SHOWS_MULTIBOUNCE
    vec3 bounces = vec3(0.0);
#if HAS_MULTIBOUNCE
    bounces = shown_bounces(a, b);
#endif
    return bounces;
#endif
#if SHOWS_RETRO
    return shown_retro(a, b);
#endif
#if SHOWS_COAT
    return vec3(0.0);
#endif
#if SHOWS_SPECULAR
    return shown_specular(a, b);
#elif SHOWS_DIFFUSE
    return shown_diffuse(a, b);
#elif CLOSED_FORM
    return shown_specular(a, b) + shown_diffuse(a, b);
#else
    return brdf_of(a, b);
#endif
}

#if HAS_ALBEDO
// Of a constant environment of radiance 1, what leaves toward k.
vec3 shown_albedo(Direction a) {
#if SHOWS_MULTIBOUNCE
    vec3 bounces = vec3(0.0);
#if HAS_MULTIBOUNCE
    bounces = shown_bounce_albedo(a);
#endif
    return bounces;
#endif
#if SHOWS_RETRO
    return shown_retro_albedo(a);
#endif
#if SHOWS_COAT
    return vec3(0.0);
#endif
#if CLOSED_FORM
    bool alone = closed_form.model == MODEL_OREN_NAYAR;
    vec3 model = closed_form_albedo(closed_form, a.k);
    vec3 first = alone ? vec3(0.0) : model;
    vec3 rest = alone ? model : diffuse_albedo(a);
#else
    vec3 first = a.R * surface.ks;
    vec3 rest = diffuse_albedo(a);
#endif
#if SHOWS_SPECULAR
    return first;
#elif SHOWS_DIFFUSE
    return rest;
#else
#if HAS_MULTIBOUNCE
    first += shown_bounce_albedo(a);
#endif
    return first + rest;
#endif
}
#endif

#if HAS_COAT
// The same through the coat, and what that adds: a model in the design's place lies beneath it too.
vec3 shown_through_coat(Direction a, Direction b) {
    vec3 rho = coat_passage(a, b) * shown_brdf(a, b);
#if SHOWS_ALL
    rho += coat_reflection(a, b);
#endif
#if SHOWS_COAT
    rho = coat_reflection(a, b);
#endif
    return rho;
}

#if HAS_ALBEDO
// Each term has its part, by its own albedo, of the light that leaves at once; the rest is the coat's.
vec3 shown_coated_albedo(Direction a) {
    vec3 own = vec3(a.coat_R) + a.passed * a.inner;
#if SHOWS_COAT
    return own;
#endif
    vec3 part = shown_albedo(a) / max(total_albedo(a), vec3(1e-9));
    vec3 sum = a.passed * (a.whole - a.inner) * part;
#if SHOWS_ALL
    sum += own;
#endif
    return sum;
}
#endif
#endif

#if SHOWS_FACTOR
// Of k1 = a and k2 = b; see terms.glsl.
vec3 factor(Direction a, Direction b) {
#if SHOWS_DENSITY
    return vec3(mirroring_density(a, b));
#elif SHOWS_MASKING_1
    return vec3(masking(a));
#elif SHOWS_MASKING_2
    return vec3(masking(b));
#elif SHOWS_FRESNEL
    return mirroring_fresnel(a, b);
#else
    return vec3(inverse_areas(a, b));
#endif
}
#endif
