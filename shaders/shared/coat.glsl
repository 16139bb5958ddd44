// A clear coat of index n over the surface. Inside, k' is k refracted at a flat border: the facets' BRDF rho_b is that in a medium
// of index n. The coat's own highlight rho_c has facets of its own, with the directional albedo R_c; what that leaves goes
// through, t = (1 - R_c) exp(-depth/c') of it:
//
//   rho(k1, k2) = rho_c(k1, k2) + t(k1) t(k2)/n^2 [rho_b(k1', k2') + b(k1') b(k2')/E],   E = integral of t b c' dk'
//
// Of the light that comes to the facets along k', `whole` leaves through the coat in the end: u = integral of rho_b (t + f u) c' dk',
// where f, what the coat sends back, has gone through it twice. b = u - integral of rho_b t c' dk' is what has been back and forth;
// it leaves evenly. So the albedo is R_c + t u, at most 1 and 1 where nothing is absorbed.

// k inside the coat.
real3 refracted(real3 k) READS {
    real x = k.x / real(surface.coat_ior);
    real y = k.y / real(surface.coat_ior);
    return real3(x, y, sqrt(max(real(1.0) - x * x - y * y, real(0.0))));
}

// k' outside the coat; 0 where it does not leave.
real3 emerging(real3 k) READS {
    real x = k.x * real(surface.coat_ior);
    real y = k.y * real(surface.coat_ior);
    real z2 = real(1.0) - x * x - y * y;
    condition leaves = z2 > real(0.0);
    return select(leaves, real3(x, y, sqrt(max(z2, real(0.0)))), real3(0.0));
}

real coat_density(real cosine) READS {
    real p = real(0.0);
#define COAT_CASE(index, density_of, area_of) if (COAT_IS(index)) p = density_of(surface.coat_width, cosine);
EACH_COAT
#undef COAT_CASE
    return p;
}

// g of the coat's own facets, their N = 1; at least c, since they stand upright.
real coat_area(real cosine) READS {
    real g = cosine;
#define COAT_CASE(index, density_of, area_of) if (COAT_IS(index)) g = area_of(surface.coat_width, cosine);
EACH_COAT
#undef COAT_CASE
    return max(g, cosine);
}

// A table of `nodes` nodes, evenly in the root of the cosine outside.
real coat_value(TableRows rows, int offset, real at) READS {
    return table_value(rows, offset, surface.tables.coat_nodes, at);
}

real3 coat_colour(TableRows rows, int offset, real at) READS {
    int size = surface.tables.coat_nodes * surface.tables.coat_rows;
    return real3(coat_value(rows, offset, at), coat_value(rows, offset + size, at), coat_value(rows, offset + 2 * size, at));
}

// R_c at the root of a cosine outside.
real coat_albedo(real at) READS {
    TableRows only;
    only.first = integer(0);
    only.second = integer(0);
    only.fraction = real(0.0);
    return clamp(table_value(only, surface.tables.coat_offset, surface.tables.coat_albedo_nodes, at), real(0.0), real(1.0));
}

// exp(-depth/c'), each colour: one way through the coat.
real3 coat_way(real cosine) READS {
    return real3(exp(real(-surface.coat_depth.x) / cosine), exp(real(-surface.coat_depth.y) / cosine),
                 exp(real(-surface.coat_depth.z) / cosine));
}

// What is known of k from what is known of the facets at k'.
Direction coated(Direction a, real3 k) READS {
    real at = sqrt(k.z);
    a.outside = k;
    a.coat_g = coat_area(k.z);
    a.coat_R = coat_albedo(at);
    a.passed = coat_way(a.k.z) * (real(1.0) - a.coat_R);
    TableSpot spot = table_spot(a.k);
    real turns = real(0.5) * (spot.turns + quarter_turns(spot.azimuth.x, spot.azimuth.y));
    TableRows rows = table_rows(turns, surface.tables.coat_rows);
    int inside = surface.tables.coat_offset + surface.tables.coat_albedo_nodes;
    int size = 3 * surface.tables.coat_nodes * surface.tables.coat_rows;
    a.whole = max(coat_colour(rows, inside, at), real3(0.0));
    a.inner = max(coat_colour(rows, inside + size, at), real3(0.0));
    return a;
}

// rho_c
real3 coat_specular(Direction a, Direction b) READS {
    HalfVector between = half_vector(a.outside, b.outside);
    real v = safe_divide(real(1.0), a.coat_g * b.coat_g);
    real rho = real(0.25) * coat_density(between.h.z) * dielectric_reflectance(real(surface.coat_ior), between.cosine) * v;
    return real3(select(between.exists, min(rho, real(LARGEST)), real(0.0)));
}

// What the coat lets through of light that the facets send from one direction into the other.
real3 coat_passage(Direction a, Direction b) READS {
    scalar square = surface.coat_ior * surface.coat_ior;
    return (a.passed * b.passed) / real(square);
}

// What the coat adds to what lies beneath: its own highlight and what has been back and forth.
real3 coat_reflection(Direction a, Direction b) READS {
    return coat_specular(a, b) + coat_passage(a, b) * (a.inner * b.inner) * real3(surface.coat_even);
}
