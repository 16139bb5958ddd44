PURE real none_density(scalar width, real cosine) {
    return real(0.0);
}

PURE real none_area(scalar width, real cosine) {
    return cosine;
}
