PURE real dome_lobe(Layer layer, real3 h) {
    return select(h.z > real(0.0), real(1.0) - layer.inverse_width.x + layer.inverse_width.x * h.z, real(0.0));
}
