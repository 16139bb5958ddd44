// Normal distributions p(h), each in its lobe's own frame (z = the lobe's axis) and not normalised.
// h has length 1. No branch depends on h, so that many directions go side by side. The curve and the pictures read the surface's data through fetch().

#if HAS_GAUSSIAN
// exp(-tan^2(theta) (cos^2(phi)/sx^2 + sin^2(phi)/sy^2)), upper hemisphere     (Ashikhmin 2000, eq. 34)
PURE real gaussian_density(real3 h, scalar2 inverse_width) {
    real x = h.x * inverse_width.x / h.z;
    real y = h.y * inverse_width.y / h.z;
    return select(h.z > real(0.0), exp(-(x * x + y * y)), real(0.0));
}
#endif

#if HAS_INVERSE_GAUSSIAN
// exp(-cot^2(theta)/s^2), upper hemisphere                                     (Ashikhmin 2000, eq. 35)
PURE real inverse_gaussian_density(real3 h, scalar inverse_width) {
    real sine2 = h.x * h.x + h.y * h.y;
    real x = h.z * inverse_width;
    return select(h.z > real(0.0) && sine2 > real(0.0), exp(-(x * x / sine2)), real(0.0));
}
#endif

#if HAS_GGX
// pi ax ay times GGX: 1/(hx^2/ax^2 + hy^2/ay^2 + hz^2)^2, upper hemisphere     (Walter 2007, eq. 33; Heitz 2014, eq. 85)
PURE real ggx_density(real3 h, scalar2 inverse_width) {
    real x = h.x * inverse_width.x;
    real y = h.y * inverse_width.y;
    real q = x * x + y * y + h.z * h.z;
    return select(h.z > real(0.0), real(1.0) / (q * q), real(0.0));
}
#endif

#if HAS_BECKMANN
// pi ax ay times Beckmann: eq. 34 over cos^4(theta)                            (Walter 2007, eq. 25)
// Past exp(-100) the exponential is 0 in float and 1/cos^4 may overflow.
PURE real beckmann_density(real3 h, scalar2 inverse_width) {
    real x = h.x * inverse_width.x / h.z;
    real y = h.y * inverse_width.y / h.z;
    real e = x * x + y * y;
    real c2 = h.z * h.z;
    return select(h.z > real(0.0) && e <= real(100.0), exp(-e) / (c2 * c2), real(0.0));
}
#endif

#if HAS_CURVE
// Straight lines between `size` points (theta in radians, value), 0 outside them.
real curve_density(real3 h, int offset, int size) READS {
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
#endif

#if HAS_PAINTED || HAS_MODULATION
// A picture at a place of the disk that touches its four sides, +x right, +y up, top row first; bilinear between texel
// centres and flat beyond the outermost. Texels off the disk hold what lies beside them on it (docs/mathematics.md).
real picture_at(real x, real y, int offset, int size) READS {
    real n = real(size);
    real column = clamp(real(0.5) * (real(1.0) + x) * n - real(0.5), real(0.0), n - real(1.0));
    real row = clamp(real(0.5) * (real(1.0) - y) * n - real(0.5), real(0.0), n - real(1.0));
    integer i0 = integer(column);
    integer j0 = integer(row);
    integer i1 = min(i0 + 1, size - 1);
    integer j1 = min(j0 + 1, size - 1);
    real s = column - real(i0);
    real t = row - real(j0);
    real top = fetch(offset + j0 * size + i0) * (real(1.0) - s) + fetch(offset + j0 * size + i1) * s;
    real bottom = fetch(offset + j1 * size + i0) * (real(1.0) - s) + fetch(offset + j1 * size + i1) * s;
    return top * (real(1.0) - t) + bottom * t;
}

// The upper hemisphere seen from above, the equal-area disk x = hx/sqrt(1+hz); 0 below it.
real picture_value(real3 h, int offset, int size) READS {
    real radius = sqrt(real(1.0) / (real(1.0) + max(h.z, real(0.0))));
    return select(h.z > real(0.0), picture_at(h.x * radius, h.y * radius, offset, size), real(0.0));
}
#endif

// The lobe of a layer at h, given in the lobe's own frame.
real lobe_density(Layer layer, real3 h) READS {
    real p = real(0.0);
#if HAS_GAUSSIAN
    if (layer.kind == LOBE_GAUSSIAN) p = gaussian_density(h, layer.inverse_width);
#endif
#if HAS_INVERSE_GAUSSIAN
    if (layer.kind == LOBE_INVERSE_GAUSSIAN) p = inverse_gaussian_density(h, layer.inverse_width.x);
#endif
#if HAS_GGX
    if (layer.kind == LOBE_GGX) p = ggx_density(h, layer.inverse_width);
#endif
#if HAS_BECKMANN
    if (layer.kind == LOBE_BECKMANN) p = beckmann_density(h, layer.inverse_width);
#endif
#if HAS_UNIFORM
    if (layer.kind == LOBE_SPHERE) p = real(1.0);
    if (layer.kind == LOBE_HEMISPHERE) p = select(h.z > real(0.0), real(1.0), real(0.0));
#endif
#if HAS_CURVE
    if (layer.kind == LOBE_CURVE) p = curve_density(h, layer.data_offset, layer.data_size);
#endif
#if HAS_PAINTED
    if (layer.kind == LOBE_PAINTED) p = picture_value(h, layer.data_offset, layer.data_size);
#endif
#if HAS_MODULATION
    if (layer.picture_size > 0 && !none(p > real(0.0))) {
        real picture = picture_value(h, layer.picture_offset, layer.picture_size);
        p *= real(1.0) - layer.picture_strength + layer.picture_strength * picture;
    }
#endif
    return p;
}

// One layer's part of p at h, given in the surface's frame.
real layer_density(Layer layer, real3 h) READS {
    real3 own = real3(dot(layer.axis_x, h), dot(layer.axis_y, h), dot(layer.axis_z, h));
    return layer.scale * lobe_density(layer, own);
}

// p(h), normalised to integral 1 over the sphere, per steradian.
real density(real3 h) READS {
    real p = real(0.0);
    for (int i = 0; i < layer_count; ++i) p += layer_density(layers[i], h);
    return p;
}
