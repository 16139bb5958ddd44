// A picture of the hemisphere.
real painted_lobe(Layer layer, real3 h) READS {
    return picture_value(h, layer.data_offset, layer.data_size);
}
