PURE real3 facets_share(Direction a) {
    return real3(1.0);
}

// kd (albedo V/pi + what more bounces bring); nothing without tables             (Ashikhmin 2000, eq. 33)
real3 facets_diffuse(Direction a, Direction b) READS {
    if (surface.tables.facet_classes == 0) return real3(0.0);
    FacetSpot here = facet_spot(a.k);
    FacetSpot there = facet_spot(b.k);
    real first = facet_visibility(a, b, here, there) * (surface.kd / TABLE_PI);
    real more = facet_rest(here) * facet_rest(there) * (surface.kd * surface.facet_even);
    return real3(surface.albedo) * first + real3(surface.facet_scale) * more;
}

real3 facets_diffuse_albedo(Direction a) READS {
    if (surface.tables.facet_classes == 0) return real3(0.0);
    real rest = facet_rest(facet_spot(a.k));
    return (real3(surface.albedo) * (real(1.0) - rest) + real3(surface.facet_scale) * rest) * surface.kd;
}
