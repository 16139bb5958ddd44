// 1 over the upper hemisphere, and over the lower one too where data_size is 1.
PURE real uniform_lobe(Layer layer, real3 h) {
    return select(h.z > real(0.0), real(1.0), real(layer.data_size));
}
