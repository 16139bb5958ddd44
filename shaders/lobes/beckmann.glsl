// pi ax ay times Beckmann: eq. 34 over cos^4(theta)                            (Walter 2007, eq. 25)
// Past exp(-100) the exponential is 0 in float and 1/cos^4 may overflow.
PURE real beckmann_density(real3 h, scalar2 inverse_width) {
    real x = h.x * inverse_width.x / h.z;
    real y = h.y * inverse_width.y / h.z;
    real e = x * x + y * y;
    real c2 = h.z * h.z;
    return select(h.z > real(0.0) && e <= real(100.0), exp(-e) / (c2 * c2), real(0.0));
}

PURE real beckmann_lobe(Layer layer, real3 h) {
    return beckmann_density(h, layer.inverse_width);
}
