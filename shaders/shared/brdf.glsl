// The BRDF. Every sum and product is in an order that does not change when k1 and k2 change places, so that
// reciprocity holds to the last bit.

// What the BRDF knows of one direction: its projected area and its albedo.
struct Direction {
    real3 k;
    real g;    // eq. 18
    real3 R;   // eq. 29; 0 when no diffuse term reads it
};

// a/b of a, b >= 0, and the largest number where that is greater or b is 0; 0/b is 0 for every b.
PURE real bounded_quotient(real a, real b) {
    return select(a < b * LARGEST, a / b, select(a > real(0.0), real(LARGEST), real(0.0)));
}

// F(cosine) of the design                                                   (eq. 31, or exact Fresnel)
real3 fresnel(real cosine) READS {
    real3 f = real3(1.0);
#if FRESNEL_SCHLICK
    if (FRESNEL_IS_SCHLICK) f = schlick_fresnel(surface.f0, cosine);
#endif
#if FRESNEL_DIELECTRIC
    if (FRESNEL_IS_DIELECTRIC) f = real3(dielectric_fresnel(surface.eta.x, cosine));
#endif
#if FRESNEL_CONDUCTOR
    if (FRESNEL_IS_CONDUCTOR) {
        f = real3(conductor_fresnel(surface.eta.x, surface.kappa.x, cosine),
                  conductor_fresnel(surface.eta.y, surface.kappa.y, cosine),
                  conductor_fresnel(surface.eta.z, surface.kappa.z, cosine));
    }
#endif
    return f;
}

#if VISIBILITY_CORRELATED
// k's tangent projection. At n, where none is left, one along the tables' axis: the first row of R's tables holds
// the limit from there.
real2 tangent_projection(real3 k) READS {
    condition upright = abs(k.x) + abs(k.y) < real(1e-15);
    return real2(select(upright, real(surface.tables.axis.x), k.x), select(upright, real(surface.tables.axis.y), k.y));
}
#endif

// P12 / (N c1 c2) with no division by a cosine: N/(G1 G2) for the uncorrelated product (eq. 26), where
// G = max(g, N c) under clamp, so that P = min(1, N c/g) conserves energy for every p. The correlated forms grow
// like 1/c where both directions graze, and stop at the largest number.
real visibility(Direction a, Direction b) READS {
    real nc1 = surface.N * a.k.z;
    real nc2 = surface.N * b.k.z;
    real g1 = a.g;
    real g2 = b.g;
    if (CLAMP_VISIBILITY) {
        g1 = max(g1, nc1);
        g2 = max(g2, nc2);
    }
    real v = bounded_quotient(real(surface.N), g1 * g2);
#if VISIBILITY_CORRELATED
    // (1-t) P1 P2 + t min(P1, P2); min(P1,P2)/(N c1 c2) = 1/max(G1 c2, G2 c1)        (eq. 14)
    if (VISIBILITY_IS_CORRELATED) {
        real2 along1 = tangent_projection(a.k);
        real2 along2 = tangent_projection(b.k);
        real cross_product = along1.x * along2.y - along1.y * along2.x;
        real dot_product = along1.x * along2.x + along1.y * along2.y;
        real angle = atan(abs(cross_product), dot_product) / surface.correlation;
        real t = exp(real(-0.5) * angle * angle);
        v = min((real(1.0) - t) * v + bounded_quotient(t, max(g1 * b.k.z, g2 * a.k.z)), real(LARGEST));
    }
#endif
#if VISIBILITY_SMITH
    // P1 P2/(P1 + P2 - P1 P2): P is Smith's G1 (Heitz 2014, eq. 99). Where the unclamped P exceeds 1 the
    // correlation takes 1, and the product stays the paper's.
    if (VISIBILITY_IS_SMITH) {
        real p1 = min(nc1 / g1, real(1.0));
        real p2 = min(nc2 / g2, real(1.0));
        v = bounded_quotient(v, (p1 + p2) - p1 * p2);
    }
#endif
    return select(g1 <= real(0.0) || g2 <= real(0.0), real(0.0), v);
}

// Of two directions: what is between them, and k.h. Two that are opposite have none.
struct HalfVector {
    real3 h;
    real cosine;
    condition exists;
};

HalfVector half_vector(real3 k1, real3 k2) READS {
    // Measured by its largest part first: two opposite grazing directions leave a sum whose square is no number.
    real3 sum = k1 + k2;
    real reach = max(max(abs(sum.x), abs(sum.y)), abs(sum.z));
    HalfVector between;
    between.exists = reach > real(0.0);
    sum = select(between.exists, sum / reach, real3(0.0, 0.0, 1.0));
    real size = length(sum);
    between.h = sum / size;
    between.cosine = min(real(0.5) * (size * reach), real(1.0));
    return between;
}

// rho = p(h) F(k.h) P12 / (4 N c1 c2), 1/sr                                  (eq. 11, 26)
real3 specular(Direction a, Direction b) READS {
    HalfVector between = half_vector(a.k, b.k);
    real p = density(between.h);
    if (none(p > real(0.0))) return real3(0.0);
    real facets = select(between.exists, real(0.25) * p * visibility(a, b), real(0.0));
    return fresnel(between.cosine) * min(facets, real(LARGEST));
}

// The part of a diffuse term that one direction brings: 1 - R, or f0 - R for the paper's metal, never < 0.
real3 diffuse_share(Direction a) READS {
    real3 whole = real3(1.0);
#if DIFFUSE_METAL
    if (DIFFUSE_IS_METAL) whole = surface.albedo;
#endif
    return max(whole - a.R, real3(0.0));
}

// Everything that leaves other than by one reflection, 1/sr                  (eq. 27, 28, 30)
real3 diffuse(Direction a, Direction b) READS {
    real3 rho = real3(0.0);
#if DIFFUSE_LAMBERTIAN
    if (DIFFUSE_IS_LAMBERTIAN) rho = surface.albedo * (surface.kd / TABLE_PI);
#endif
#if DIFFUSE_COUPLED || DIFFUSE_METAL
    if (DIFFUSE_IS_COUPLED || DIFFUSE_IS_METAL) {
        rho = (diffuse_share(a) * diffuse_share(b)) * (surface.coupling * surface.albedo);
    }
#endif
    return rho;
}

// The weight of the specular term: ks of eq. 27, else 1.
real specular_weight() READS {
#if DIFFUSE_LAMBERTIAN
    if (DIFFUSE_IS_LAMBERTIAN) return surface.ks;
#endif
    return real(1.0);
}

#if HAS_ALBEDO
// g/G: 1 where the clamp does not cut in.
real clamped_part(real3 k, real g) READS {
    real nc = surface.N * k.z;
    return select(CLAMP_VISIBILITY && g < nc, g / nc, real(1.0));
}

// R(k) of the design's own Fresnel factor, from the tables.
real3 albedo_of(real3 k, real g, AlbedoSpot spot) READS {
    real full = full_albedo(spot);
    real3 r = real3(full);
#if FRESNEL_SCHLICK
    if (FRESNEL_IS_SCHLICK) {
        real zero = fresnel_albedo(spot, full, schlick_weight(k.z), 0);
        r = real3(surface.f0) * full + (real3(1.0) - surface.f0) * zero;
    }
#endif
#if FRESNEL_DIELECTRIC || FRESNEL_CONDUCTOR
    if (FRESNEL_IS_DIELECTRIC || FRESNEL_IS_CONDUCTOR) {
        real3 f = fresnel(k.z);
        r = real3(fresnel_albedo(spot, full, f.x, 0), fresnel_albedo(spot, full, f.y, 1),
                  fresnel_albedo(spot, full, f.z, 2));
    }
#endif
    return r * clamped_part(k, g);
}
#endif

// Reads the tables for k, which stands above the horizon.
Direction direction(real3 k) READS {
    Direction a;
    TableSpot spot = table_spot(k);
    a.k = k;
    a.g = projected_area(k, spot);
    a.R = real3(0.0);
#if HAS_ALBEDO
    if (READS_ALBEDO) a.R = albedo_of(k, a.g, albedo_spot(k, spot));
#endif
    return a;
}

#if HAS_ALBEDO
// What of a constant surrounding of radiance 1 the diffuse terms send toward k. The constant c of eq. 28 makes the
// coupled term's albedo its share times rho_d.
real3 diffuse_albedo(Direction a) READS {
    real3 sum = real3(0.0);
#if DIFFUSE_LAMBERTIAN
    if (DIFFUSE_IS_LAMBERTIAN) sum = surface.albedo * surface.kd;
#endif
#if DIFFUSE_COUPLED || DIFFUSE_METAL
    if (DIFFUSE_IS_COUPLED || DIFFUSE_IS_METAL) sum = diffuse_share(a) * surface.albedo;
#endif
    return sum;
}

// The same of the whole BRDF: its albedo.
real3 total_albedo(Direction a) READS {
    return a.R * specular_weight() + diffuse_albedo(a);
}
#endif

real3 brdf_of(Direction a, Direction b) READS {
    return specular(a, b) * specular_weight() + diffuse(a, b);
}

// The BRDF of unit vectors in the local frame, 1/sr; 0 where either is not above the horizon.
real3 brdf(real3 k1, real3 k2) READS {
    condition above = k1.z > real(0.0) && k2.z > real(0.0);
    if (none(above)) return real3(0.0);
    real3 n = real3(0.0, 0.0, 1.0);
    real3 rho = brdf_of(direction(select(above, k1, n)), direction(select(above, k2, n)));
    return select(above, rho, real3(0.0));
}
