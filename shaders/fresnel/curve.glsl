// Drawn by hand, as a table: a.y nodes.
real3 curve_fresnel(scalar3 a, scalar3 b, real cosine) READS {
    return table_fresnel(a, cosine);
}
