// The BRDF. Every sum and product is in an order that does not change when k1 and k2 change places, so that
// reciprocity holds to the last bit.

// F(cosine) of the design, by its model of shaders/fresnel/
real3 fresnel(real cosine) READS {
    real3 f = real3(1.0);
#define FRESNEL_CASE(index, model) if (FRESNEL_IS(index)) f = model(surface.fresnel_a, surface.fresnel_b, cosine);
EACH_FRESNEL
#undef FRESNEL_CASE
    return f;
}

// rho = p(h) F(k.h) P12 / (4 N c1 c2), 1/sr; p = density(between.h)           (eq. 11, 26)
real3 specular_of(Direction a, Direction b, HalfVector between, real p) READS {
    if (none(p > real(0.0))) return real3(0.0);
    real facets = select(between.exists, real(0.25) * p * visibility(a, b), real(0.0));
#if HAS_TINT
    if (TINTED) return fresnel(between.cosine) * facet_tint(between.h, p) * min(facets, real(LARGEST));
#endif
    return fresnel(between.cosine) * min(facets, real(LARGEST));
}

real3 specular(Direction a, Direction b) READS {
    HalfVector between = half_vector(a.k, b.k);
    return specular_of(a, b, between, density(between.h));
}

#if HAS_RETRO
// rho_r = [rho(k1, T k2) + rho(T k1, k2)]/2, see retro.glsl.
real3 retro_specular(Direction a, Direction b) READS {
    return specular(turned(a), b) * real(0.5) + specular(a, turned(b)) * real(0.5);
}

#endif
// With the part of it that the design sends back.
real3 whole_specular(Direction a, Direction b) READS {
#if HAS_RETRO
    if (IS_RETRO) return retro_mixed(specular(a, b), retro_specular(a, b));
#endif
    return specular(a, b);
}

#if HAS_MULTIBOUNCE
// The same of more bounces, so that energy is conserved for every p.
real3 whole_multibounce(Direction a, Direction b) READS {
#if HAS_RETRO
    if (IS_RETRO) {
        real3 back = multibounce(turned(a), b) * real(0.5) + multibounce(a, turned(b)) * real(0.5);
        return retro_mixed(multibounce(a, b), back);
    }
#endif
    return multibounce(a, b);
}

#endif
// The part of a diffuse term that one direction brings, 0 to 1, by the model of shaders/diffuse/.
real3 diffuse_share(Direction a) READS {
    real3 share = real3(0.0);
#define DIFFUSE_CASE(index, share_of, diffuse_of, albedo_of) if (DIFFUSE_IS(index)) share = share_of(a);
EACH_DIFFUSE
#undef DIFFUSE_CASE
    return share;
}

// Everything that leaves other than by one reflection, 1/sr.
real3 diffuse(Direction a, Direction b) READS {
    real3 rho = real3(0.0);
#define DIFFUSE_CASE(index, share_of, diffuse_of, albedo_of) if (DIFFUSE_IS(index)) rho = diffuse_of(a, b);
EACH_DIFFUSE
#undef DIFFUSE_CASE
    return rho;
}

#if HAS_ALBEDO
// g/G: 1 where the clamp does not cut in.
real clamped_part(real3 k, real g) READS {
    real nc = surface.N * k.z;
    return select(CLAMP_VISIBILITY && g < nc, g / nc, real(1.0));
}

#if HAS_TINT
// R G/g of the design's own Fresnel factor where tints differ and each colour has tables of its own.
real3 varied_albedo(real3 k, AlbedoSpot spot) READS {
    real3 full = colour_albedo_f1(spot);
    real3 r = full;
#if HAS_LINEAR_FRESNEL
    if (FRESNEL_IS_LINEAR) {
        real3 zero = colour_fresnel_albedo(spot, full, real3(schlick_weight(k.z)));
        r = real3(surface.fresnel_a) * full + (real3(1.0) - surface.fresnel_a) * zero;
    }
#endif
#if HAS_EXACT_FRESNEL
    if (FRESNEL_IS_EXACT) r = colour_fresnel_albedo(spot, full, fresnel(k.z));
#endif
    return r;
}

#endif
// R(k) of the design's own Fresnel factor, from the tables.
real3 albedo_of(real3 k, real g, AlbedoSpot spot) READS {
#if HAS_TINT
    if (TINT_VARIES) return varied_albedo(k, spot) * clamped_part(k, g);
#endif
    real full = albedo_f1(spot);
    real3 r = real3(full);
#if HAS_LINEAR_FRESNEL
    if (FRESNEL_IS_LINEAR) {
        real zero = fresnel_albedo(spot, full, schlick_weight(k.z), 0);
        r = real3(surface.fresnel_a) * full + (real3(1.0) - surface.fresnel_a) * zero;
    }
#endif
#if HAS_EXACT_FRESNEL
    if (FRESNEL_IS_EXACT) {
        real3 f = fresnel(k.z);
        r = real3(fresnel_albedo(spot, full, f.x, 0), fresnel_albedo(spot, full, f.y, 1),
                  fresnel_albedo(spot, full, f.z, 2));
    }
#endif
#if HAS_TINT
    if (TINTED) r = r * real3(layers[0].tint);
#endif
    return r * clamped_part(k, g);
}
#endif

#if HAS_RETRO
#if HAS_MULTIBOUNCE
// With what bounces need of T k, whose g is known.
Direction with_turned_bounces(Direction a) READS {
    Direction other = a;
    other.k = turned(a.k);
    if (surface.tables.symmetry == SYMMETRY_HALF || surface.tables.symmetry == SYMMETRY_NONE)
        other = with_bounces(other, albedo_spot(other.k, table_spot(other.k)), clamped_part(other.k, a.turned_g));
    a.turned_amplitude = other.amplitude;
    a.turned_rest = other.rest;
    a.turned_bounce_F = other.bounce_F;
    a.M = retro_mixed(a.M, (a.M + other.M) * real(0.5));
    return a;
}

#endif
// With what is known of T k. Where two mirror planes stand on n it sees the same.
Direction with_turned(Direction a) READS {
    real3 turned_R = a.R;
    a.turned_g = a.g;
    if (surface.tables.symmetry == SYMMETRY_HALF || surface.tables.symmetry == SYMMETRY_NONE) {
        real3 k = turned(a.k);
        TableSpot spot = table_spot(k);
        a.turned_g = projected_area(k, spot);
#if HAS_ALBEDO
        if (READS_ALBEDO) turned_R = albedo_of(k, a.turned_g, albedo_spot(k, spot));
#endif
    }
#if HAS_MULTIBOUNCE
    if (BOUNCES) a = with_turned_bounces(a);
#endif
    a.retro_R = (a.R + turned_R) * real(0.5);
    a.R = retro_mixed(a.R, a.retro_R);
    return a;
}

#endif
// Reads the tables for k, which is above the horizon.
Direction direction(real3 k) READS {
#if HAS_COAT
    real3 outside = k;
    if (IS_COATED) k = refracted(k);
#endif
    Direction a;
    TableSpot spot = table_spot(k);
    a.k = k;
    a.g = projected_area(k, spot);
    a.R = real3(0.0);
#if HAS_ALBEDO
    if (READS_ALBEDO) a.R = albedo_of(k, a.g, albedo_spot(k, spot));
#endif
#if HAS_MULTIBOUNCE
    if (BOUNCES) a = with_bounces(a, albedo_spot(k, spot), clamped_part(k, a.g));
#endif
#if HAS_RETRO
    if (IS_RETRO) a = with_turned(a);
#endif
#if HAS_COAT
    if (IS_COATED) a = coated(a, outside);
#endif
    return a;
}

#if HAS_ALBEDO
// What of a constant environment of radiance 1 the diffuse term sends toward k.
real3 diffuse_albedo(Direction a) READS {
    real3 sum = real3(0.0);
#define DIFFUSE_CASE(index, share_of, diffuse_of, albedo_of) if (DIFFUSE_IS(index)) sum = albedo_of(a);
EACH_DIFFUSE
#undef DIFFUSE_CASE
    return sum;
}

// The same of the whole BRDF: its albedo.
real3 total_albedo(Direction a) READS {
#if HAS_MULTIBOUNCE
    if (BOUNCES) return (a.R + a.M) * surface.ks + diffuse_albedo(a);
#endif
    return a.R * surface.ks + diffuse_albedo(a);
}
#if HAS_COAT

// With the coat over it.
real3 coated_albedo(Direction a) READS {
    if (IS_COATED) return real3(a.coat_R) + a.passed * a.whole;
    return total_albedo(a);
}
#endif
#endif

real3 brdf_of(Direction a, Direction b) READS {
#if HAS_MULTIBOUNCE
    if (BOUNCES) return (whole_specular(a, b) + whole_multibounce(a, b)) * surface.ks + diffuse(a, b);
#endif
#if HAS_RETRO
    if (IS_RETRO) return whole_specular(a, b) * surface.ks + diffuse(a, b);
#endif
    return specular(a, b) * surface.ks + diffuse(a, b);
}

#if HAS_COAT
// With the coat over it.
real3 coated_brdf_of(Direction a, Direction b) READS {
    if (IS_COATED) return coat_reflection(a, b) + coat_passage(a, b) * brdf_of(a, b);
    return brdf_of(a, b);
}

#endif
// The BRDF of unit vectors in the local frame, 1/sr; 0 where either is not above the horizon.
real3 brdf(real3 k1, real3 k2) READS {
    condition above = k1.z > real(0.0) && k2.z > real(0.0);
    if (none(above)) return real3(0.0);
    real3 n = real3(0.0, 0.0, 1.0);
    Direction a = direction(select(above, k1, n));
    Direction b = direction(select(above, k2, n));
    real3 rho = brdf_of(a, b);
#if HAS_COAT
    rho = coated_brdf_of(a, b);
#endif
    return select(above, rho, real3(0.0));
}
