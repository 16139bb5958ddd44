// Normal distributions p(h) by the lobes of shaders/lobes/: each in its own frame (z = the lobe's axis) and not
// normalised. h has length 1. No branch depends on h, so that many directions go side by side. Curves and pictures read
// the surface's data through fetch().

// The lobe of a layer at h, given in the lobe's own frame.
real lobe_density(Layer layer, real3 h) READS {
    real p = real(0.0);
#define LOBE_CASE(index, lobe) if (layer.kind == index) p = lobe(layer, h);
EACH_LOBE
#undef LOBE_CASE
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
#if HAS_TINT

// What the facets of normal h reflect besides F, the mean of their layers' tints: q(h)/p(h) where q is the sum of p over
// the layers, each times its tint. p = density(h).
real3 facet_tint(real3 h, real p) READS {
    real3 tint = real3(layers[0].tint);
    if (TINT_VARIES) {
        real3 q = real3(0.0);
        for (int i = 0; i < layer_count; ++i) q += real3(layers[i].tint) * layer_density(layers[i], h);
        tint = q / select(p > real(0.0), p, real(1.0));
    }
    return tint;
}
#endif
