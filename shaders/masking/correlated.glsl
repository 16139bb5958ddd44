// k's tangent projection. At n, where none is left, one along the tables' axis: the first row of R's tables holds
// the limit from there.
real2 correlated_projection(real3 k) READS {
    condition upright = abs(k.x) + abs(k.y) < real(1e-15);
    return real2(select(upright, real(surface.tables.axis.x), k.x), select(upright, real(surface.tables.axis.y), k.y));
}

// (1-t) P1 P2 + t min(P1, P2); min(P1,P2)/(N c1 c2) = 1/max(G1 c2, G2 c1)        (Ashikhmin 2000, eq. 14)
// width: standard deviation of t(phi), radians.
real correlated_masking(scalar width, Direction a, Direction b, real g1, real g2, scalar N, real v) READS {
    real2 along1 = correlated_projection(a.k);
    real2 along2 = correlated_projection(b.k);
    real cross_product = along1.x * along2.y - along1.y * along2.x;
    real dot_product = along1.x * along2.x + along1.y * along2.y;
    real angle = atan(abs(cross_product), dot_product) / width;
    real t = exp(real(-0.5) * angle * angle);
    return min((real(1.0) - t) * v + safe_divide(t, max(g1 * b.k.z, g2 * a.k.z)), real(LARGEST));
}
