// Thin films, as a table: a.y nodes.
real3 film_fresnel(scalar3 a, scalar3 b, real cosine) READS {
    return table_fresnel(a, cosine);
}
