// V = P12/(N c1 c2) with no division by a cosine: N/(G1 G2) for the uncorrelated product (eq. 26), which a model of
// shaders/masking/ turns into its own. G = max(g, N c) under clamp, so that P = min(1, N c/g) conserves energy for every
// p. The correlated forms grow like 1/c where both directions graze, and stop at the largest number.
real visibility(Direction a, Direction b) READS {
    real nc1 = surface.N * a.k.z;
    real nc2 = surface.N * b.k.z;
    real g1 = a.g;
    real g2 = b.g;
    if (CLAMP_VISIBILITY) {
        g1 = max(g1, nc1);
        g2 = max(g2, nc2);
    }
    real v = safe_divide(real(surface.N), g1 * g2);
#define MASKING_CASE(index, model) if (MASKING_IS(index)) v = model(surface.masking_width, a, b, g1, g2, surface.N, v);
EACH_MASKING
#undef MASKING_CASE
    return select(g1 <= real(0.0) || g2 <= real(0.0), real(0.0), v);
}
