// Normal distributions p(h), each in its lobe's own frame (z = the lobe's axis) and not normalised.
// h has length 1. The curve and the pictures read the surface's data through fetch().

#if HAS_GAUSSIAN
// exp(-tan^2(theta) (cos^2(phi)/sx^2 + sin^2(phi)/sy^2)), upper hemisphere     (Ashikhmin 2000, eq. 34)
PURE real gaussian_density(real3 h, real2 inverse_width) {
    if (h.z <= real(0.0)) return real(0.0);
    real x = h.x * inverse_width.x / h.z;
    real y = h.y * inverse_width.y / h.z;
    return exp(-(x * x + y * y));
}
#endif

#if HAS_INVERSE_GAUSSIAN
// exp(-cot^2(theta)/s^2), upper hemisphere                                     (Ashikhmin 2000, eq. 35)
PURE real inverse_gaussian_density(real3 h, real inverse_width) {
    real sine2 = h.x * h.x + h.y * h.y;
    if (h.z <= real(0.0) || sine2 <= real(0.0)) return real(0.0);
    real x = h.z * inverse_width;
    return exp(-(x * x / sine2));
}
#endif

#if HAS_GGX
// pi ax ay times GGX: 1/(hx^2/ax^2 + hy^2/ay^2 + hz^2)^2, upper hemisphere     (Walter 2007, eq. 33; Heitz 2014, eq. 85)
PURE real ggx_density(real3 h, real2 inverse_width) {
    if (h.z <= real(0.0)) return real(0.0);
    real x = h.x * inverse_width.x;
    real y = h.y * inverse_width.y;
    real q = x * x + y * y + h.z * h.z;
    return real(1.0) / (q * q);
}
#endif

#if HAS_BECKMANN
// pi ax ay times Beckmann: eq. 34 over cos^4(theta)                            (Walter 2007, eq. 25)
// Past exp(-100) the exponential is 0 in float and 1/cos^4 may overflow.
PURE real beckmann_density(real3 h, real2 inverse_width) {
    if (h.z <= real(0.0)) return real(0.0);
    real x = h.x * inverse_width.x / h.z;
    real y = h.y * inverse_width.y / h.z;
    real e = x * x + y * y;
    if (e > real(100.0)) return real(0.0);
    real c2 = h.z * h.z;
    return exp(-e) / (c2 * c2);
}
#endif

#if HAS_CURVE
// Straight lines between `size` points (theta in radians, value), 0 outside them.
real curve_density(real3 h, int offset, int size) READS {
    real theta = atan(sqrt(h.x * h.x + h.y * h.y), h.z);
    int low = 0;
    int high = size - 1;
    if (theta < fetch(offset) || theta > fetch(offset + 2 * high)) return real(0.0);
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (theta < fetch(offset + 2 * middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    real a = fetch(offset + 2 * low);
    real b = fetch(offset + 2 * high);
    real t = (theta - a) / (b - a);
    return fetch(offset + 2 * low + 1) * (real(1.0) - t) + fetch(offset + 2 * high + 1) * t;
}
#endif

#if HAS_PAINTED || HAS_MODULATION
// A picture of the upper hemisphere seen from above, the equal-area disk x = hx/sqrt(1+hz) that touches
// the four sides, +x right, +y up, top row first; bilinear between texel centres, 0 below the hemisphere.
real picture_value(real3 h, int offset, int size) READS {
    if (h.z <= real(0.0)) return real(0.0);
    real radius = sqrt(real(1.0) / (real(1.0) + h.z));
    real n = real(size);
    real column = clamp(real(0.5) * (real(1.0) + h.x * radius) * n - real(0.5), real(0.0), n - real(1.0));
    real row = clamp(real(0.5) * (real(1.0) - h.y * radius) * n - real(0.5), real(0.0), n - real(1.0));
    int i0 = int(column);
    int j0 = int(row);
    int i1 = min(i0 + 1, size - 1);
    int j1 = min(j0 + 1, size - 1);
    real s = column - real(i0);
    real t = row - real(j0);
    real top = fetch(offset + j0 * size + i0) * (real(1.0) - s) + fetch(offset + j0 * size + i1) * s;
    real bottom = fetch(offset + j1 * size + i0) * (real(1.0) - s) + fetch(offset + j1 * size + i1) * s;
    return top * (real(1.0) - t) + bottom * t;
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
    if (layer.kind == LOBE_SPHERE || (layer.kind == LOBE_HEMISPHERE && h.z > real(0.0))) p = real(1.0);
#endif
#if HAS_CURVE
    if (layer.kind == LOBE_CURVE) p = curve_density(h, layer.data_offset, layer.data_size);
#endif
#if HAS_PAINTED
    if (layer.kind == LOBE_PAINTED) p = picture_value(h, layer.data_offset, layer.data_size);
#endif
#if HAS_MODULATION
    if (layer.picture_size > 0 && p > real(0.0)) {
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
