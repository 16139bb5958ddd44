// P1 P2                                                                     (Ashikhmin 2000, eq. 26)
PURE real uncorrelated_masking(scalar width, Direction a, Direction b, real g1, real g2, scalar N, real v) {
    return v;
}
