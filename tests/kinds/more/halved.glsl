PURE real halved_masking(scalar width, Direction a, Direction b, real g1, real g2, scalar N, real v) {
    return real(0.5) * v;
}
