// Nothing but what is spread evenly.
PURE real flat_amplitude(real3 k) {
    return real(0.0);
}

PURE real flat_row(AlbedoSpot spot) {
    return real(0.0);
}

PURE real3 flat_spread(AlbedoSpot spot, real row) {
    return real3(0.0);
}

PURE real flat_kernel(Direction a, Direction b) {
    return real(0.0);
}
