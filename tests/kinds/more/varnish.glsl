PURE real varnish_density(scalar width, real cosine) {
    return real(1.0 / TABLE_PI);
}

PURE real varnish_area(scalar width, real cosine) {
    return real(0.5) * (real(1.0) + cosine);
}
