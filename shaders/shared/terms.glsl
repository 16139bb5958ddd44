// The factors of the BRDF, each by itself. For the uncorrelated product (eq. 26)
//
//   specular = F(k.h) p(h) N/4 * 1/(g1 g2),    1/(g1 g2) = P1 P2/(N^2 c1 c2)

// P(k) = N c/g: the part of the facets turned to k that k sees, at most 1 under clamp           (eq. 25)
real masking(Direction a) READS {
    real nc = surface.N * a.k.z;
    real g = a.g;
    if (CLAMP_VISIBILITY) g = max(g, nc);
    return safe_divide(nc, g);
}

// p(h) of the facets that mirror one direction into the other, 1/sr; 0 where no facet can.
real mirroring_density(Direction a, Direction b) READS {
    HalfVector between = half_vector(a.k, b.k);
    return select(between.exists, density(between.h), real(0.0));
}

// F(k.h) of those facets.
real3 mirroring_fresnel(Direction a, Direction b) READS {
    return fresnel(half_vector(a.k, b.k).cosine);
}

// 1/(g1 g2), p normalised to 1; with a correlated masking what replaces it: P12/(N^2 c1 c2).
real inverse_areas(Direction a, Direction b) READS {
    return safe_divide(visibility(a, b), real(surface.N));
}
