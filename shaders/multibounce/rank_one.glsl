// Nothing besides what is spread evenly.
PURE real rank_one_amplitude(real3 k) {
    return real(0.0);
}

PURE real rank_one_row(AlbedoSpot spot) {
    return real(0.0);
}

PURE real3 rank_one_spread(AlbedoSpot spot, real row) {
    return real3(0.0);
}

PURE real rank_one_kernel(Direction a, Direction b) {
    return real(0.0);
}
