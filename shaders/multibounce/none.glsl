PURE real none_amplitude(real3 k) {
    return real(0.0);
}

PURE real none_row(AlbedoSpot spot) {
    return real(0.0);
}

PURE real3 none_spread(AlbedoSpot spot, real row) {
    return real3(0.0);
}

PURE real none_kernel(Direction a, Direction b) {
    return real(0.0);
}
