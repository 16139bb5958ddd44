// exp(-cot^2(theta)/s^2), upper hemisphere                                     (Ashikhmin 2000, eq. 35)
PURE real inverse_gaussian_density(real3 h, scalar inverse_width) {
    real sine2 = h.x * h.x + h.y * h.y;
    real x = h.z * inverse_width;
    return select(h.z > real(0.0) && sine2 > real(0.0), exp(-(x * x / sine2)), real(0.0));
}

PURE real inverse_gaussian_lobe(Layer layer, real3 h) {
    return inverse_gaussian_density(h, layer.inverse_width.x);
}
