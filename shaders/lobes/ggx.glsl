// pi ax ay times GGX: 1/(hx^2/ax^2 + hy^2/ay^2 + hz^2)^2, upper hemisphere     (Walter 2007, eq. 33; Heitz 2014, eq. 85)
PURE real ggx_density(real3 h, scalar2 inverse_width) {
    real x = h.x * inverse_width.x;
    real y = h.y * inverse_width.y;
    real q = x * x + y * y + h.z * h.z;
    return select(h.z > real(0.0), real(1.0) / (q * q), real(0.0));
}

PURE real ggx_lobe(Layer layer, real3 h) {
    return ggx_density(h, layer.inverse_width);
}
