// (1-t) P1 P2 + t min(P1, P2); min(P1,P2)/(N c1 c2) = 1/max(G1 c2, G2 c1)        (Ashikhmin 2000, eq. 14)
// width: standard deviation of t(phi), radians.
PURE real correlated_masking(scalar width, Direction a, Direction b, real g1, real g2, scalar N, real v) {
    real cross_product = a.k.x * b.k.y - a.k.y * b.k.x;
    real dot_product = a.k.x * b.k.x + a.k.y * b.k.y;
    // At n itself, where P = 1 and t counts for nothing, no azimuth is left.
    condition upright = cross_product == real(0.0) && dot_product == real(0.0);
    real angle = atan(abs(cross_product), select(upright, real(1.0), dot_product)) / width;
    real t = exp(real(-0.5) * angle * angle);
    return min((real(1.0) - t) * v + bounded_quotient(t, max(g1 * b.k.z, g2 * a.k.z)), real(LARGEST));
}
