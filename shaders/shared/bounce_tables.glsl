// What light meets that bounces on, from tables at R's nodes; see multibounce.glsl.

// Table number `table` of those that begin at `offset`.
real bounce_table(AlbedoSpot spot, int offset, int table) READS {
    int nodes = surface.tables.nodes_v;
    return table_value(spot.rho, offset + table * nodes * surface.tables.nodes_rho, nodes, spot.v);
}

// F(k), the tints of the facets with it.
real3 bounce_factor(AlbedoSpot spot) READS {
    int offset = surface.tables.factor_offset;
    real3 f = real3(1.0);
    if (BOUNCE_FACTORS == 1)
        f = real3(surface.fresnel_a) + (real3(1.0) - surface.fresnel_a) * bounce_table(spot, offset, 0);
    if (BOUNCE_FACTORS == 3)
        f = real3(bounce_table(spot, offset, 0), bounce_table(spot, offset, 1), bounce_table(spot, offset, 2));
#if HAS_TINT
    if (TINTED && !TINT_VARIES) f = f * real3(layers[0].tint);
#endif
    return f;
}

// What M brings toward k of light from everywhere, over a(k), each of the other ends with its F. `row` is that with F = 1.
real3 bounce_row(AlbedoSpot spot, real row) READS {
    int offset = surface.tables.spread_offset;
    real3 spread = real3(row);
    if (BOUNCE_FACTORS == 1)
        spread = real3(surface.fresnel_a) * row + (real3(1.0) - surface.fresnel_a) * bounce_table(spot, offset, 0);
    if (BOUNCE_FACTORS == 3)
        spread = real3(bounce_table(spot, offset, 0), bounce_table(spot, offset, 1), bounce_table(spot, offset, 2));
#if HAS_TINT
    if (TINTED && !TINT_VARIES) spread = spread * real3(layers[0].tint);
#endif
    return spread;
}

// E G/g.
real bounce_whole(AlbedoSpot spot) READS {
#if HAS_TINT
    if (TINT_VARIES) return max(bounce_table(spot, surface.tables.whole_offset, 0), real(0.0));
#endif
    return albedo_f1(spot);
}
