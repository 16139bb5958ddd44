// P1 P2/(P1 + P2 - P1 P2): P is Smith's G1 (Heitz 2014, eq. 99). Where the unclamped P exceeds 1 the correlation takes 1, and
// the product stays the paper's.
PURE real smith_correlated_masking(scalar width, Direction a, Direction b, real g1, real g2, scalar N, real v) {
    real p1 = min(N * a.k.z / g1, real(1.0));
    real p2 = min(N * b.k.z / g2, real(1.0));
    return safe_divide(v, (p1 + p2) - p1 * p2);
}
