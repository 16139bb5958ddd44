// exp(-tan^2(theta) (cos^2(phi)/sx^2 + sin^2(phi)/sy^2)), upper hemisphere     (Ashikhmin 2000, eq. 34)
PURE real gaussian_density(real3 h, scalar2 inverse_width) {
    real x = h.x * inverse_width.x / h.z;
    real y = h.y * inverse_width.y / h.z;
    return select(h.z > real(0.0), exp(-(x * x + y * y)), real(0.0));
}

PURE real gaussian_lobe(Layer layer, real3 h) {
    return gaussian_density(h, layer.inverse_width);
}
