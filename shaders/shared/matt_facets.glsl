// Facets that are matt themselves (Ashikhmin 2000, eq. 33): of white ones rho = V/pi after one bounce,
//
//   V = N Q/(G1 G2) under the uncorrelated masking,   Q(k1, k2) = integral of (k1.h)+ (k2.h)+ p(h) dh
//
// Where facets turn away G is all but 0: the tables hold N Q/(K1 K2), K^2 = G^2 + (S/8)^2, S = c g(n) + 2 q of tables.glsl. That
// is positive semidefinite, so a sum of products u(k1) u(k2) of one function: here of a few tables u over (w, psi), in classes
// of as many terms each. Where p has mirror planes u is even or odd about each; where p is
// isotropic u goes with cos(m phi), and the product with cos(m (phi1 - phi2)).
//
// E is the albedo of that first bounce. Light that it keeps goes from facet to facet and leaves evenly:
// (1 - E1)(1 - E2)/(pi <1 - E>) (Kulla & Conty 2017) times what is left of each colour.

// Where k lies in these tables.
struct FacetSpot {
    TableRows psi;
    real w;
    real scale;   // S
    real across;  // -1 beyond the mirror plane that holds the tables' axis, else 1
    real along;   // -1 beyond the one at right angles to it, else 1
    real2 azimuth;  // a unit vector
};

FacetSpot facet_spot(real3 k) READS {
    TableSpot at = table_spot(k);
    real x = surface.tables.axis.x * k.x + surface.tables.axis.y * k.y;
    real y = surface.tables.axis.x * k.y - surface.tables.axis.y * k.x;
    real size = sqrt(x * x + y * y);
    condition upright = size <= real(0.0);
    FacetSpot spot;
    spot.psi = table_rows(at.turns, surface.tables.facet_rows);
    spot.w = at.w;
    spot.scale = at.scale;
    spot.across = select(y < real(0.0), real(-1.0), real(1.0));
    spot.along = select(x < real(0.0), real(-1.0), real(1.0));
    spot.azimuth = real2(select(upright, real(1.0), x / size), select(upright, real(0.0), y / size));
    return spot;
}

real facet_table(FacetSpot spot, int table) READS {
    int size = surface.tables.facet_nodes * surface.tables.facet_rows;
    return table_value(spot.psi, surface.tables.facet_offset + table * size, surface.tables.facet_nodes, spot.w);
}

// The sign of a class beside that of the first, which is even about both planes.
PURE real facet_side(FacetSpot spot, int class_index) {
    if (class_index == 1) return spot.across;
    if (class_index == 2) return spot.along;
    return spot.across * spot.along;
}

// N Q/(K1 K2)
real facet_product(FacetSpot a, FacetSpot b) READS {
    real cosine = a.azimuth.x * b.azimuth.x + a.azimuth.y * b.azimuth.y;
    real before = cosine;
    real factor = real(1.0);
    real sum = real(0.0);
    for (int c = 0; c < surface.tables.facet_classes; ++c) {
        real part = real(0.0);
        for (int i = 0; i < surface.tables.facet_terms; ++i) {
            int term = c * surface.tables.facet_terms + i;
            part = part + facet_table(a, term) * facet_table(b, term);
        }
        sum = sum + factor * part;
        if (surface.tables.symmetry == SYMMETRY_ISOTROPIC) {
            real after = real(2.0) * cosine * factor - before;
            before = factor;
            factor = after;
        } else {
            factor = facet_side(a, c + 1) * facet_side(b, c + 1);
        }
    }
    return max(sum, real(0.0));
}

// K
real facet_area(Direction a, FacetSpot spot) READS {
    real G = a.g;
    if (CLAMP_VISIBILITY) G = max(G, surface.N * a.k.z);
    return sqrt(G * G + spot.scale * spot.scale * real(0.015625));
}

// V as the design masks it.
real facet_visibility(Direction a, Direction b, FacetSpot here, FacetSpot there) READS {
    real areas = facet_area(a, here) * facet_area(b, there);
    return min(visibility(a, b) * areas * (facet_product(here, there) / surface.N), real(LARGEST));
}

// 1 - E
real facet_rest(FacetSpot spot) READS {
    int table = surface.tables.facet_classes * surface.tables.facet_terms;
    return clamp(real(1.0) - facet_table(spot, table), real(0.0), real(1.0));
}
