// Straight lines between `size` points (theta in radians, value), 0 outside them.
real curve_lobe(Layer layer, real3 h) READS {
    int size = layer.data_size;
    int offset = layer.data_offset;
    real theta = atan(sqrt(h.x * h.x + h.y * h.y), h.z);
    int step = 1;
    while (2 * step < size) step *= 2;
    integer low = integer(0);
    for (; step > 0; step /= 2) {
        integer next = min(low + step, size - 2);
        low = select(theta < fetch(offset + 2 * next), low, next);
    }
    integer at = offset + 2 * low;
    real a = fetch(at);
    real b = fetch(at + 2);
    real t = (theta - a) / (b - a);
    real value = fetch(at + 1) * (real(1.0) - t) + fetch(at + 3) * t;
    return select(theta >= a && theta <= b, value, real(0.0));
}
