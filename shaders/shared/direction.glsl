// What the BRDF knows of one direction: its projected area and its albedo.
struct Direction {
    real3 k;
    real g;    // eq. 18
    real3 R;   // eq. 29; 0 when no diffuse term reads it
#if HAS_MULTIBOUNCE
    real amplitude OR_ZERO;  // a of a fitted model; see multibounce.glsl
    real rest OR_ZERO;       // e
    real3 bounce_F OR_ZERO;  // F(k) of light that bounces on
    real3 M OR_ZERO;         // albedo of two and more bounces
#endif
#if HAS_RETRO
    real turned_g OR_ZERO;  // of T k
    real3 retro_R OR_ZERO;  // of the retro-reflective form; R is that of the mixture
#if HAS_MULTIBOUNCE
    real turned_amplitude OR_ZERO;
    real turned_rest OR_ZERO;
    real3 turned_bounce_F OR_ZERO;
#endif
#endif
#if HAS_COAT
    real3 outside OR_ZERO;  // k; the rest is of k inside the coat
    real coat_g OR_ZERO;    // projected area of the coat's own facets
    real coat_R OR_ZERO;    // albedo of its highlight
    real3 passed OR_ZERO;   // t: what goes through it
    real3 whole OR_ZERO;    // u: what of the light beneath leaves in the end
    real3 inner OR_ZERO;    // b: the part of that which has been back and forth
#endif
};

// a/b of a, b >= 0, and the largest number where that is greater or b is 0; 0/b is 0 for every b.
PURE real safe_divide(real a, real b) {
    return select(a < b * LARGEST, a / b, select(a > real(0.0), real(LARGEST), real(0.0)));
}

// Of two directions: what is between them, and k.h. Two that are opposite have none.
struct HalfVector {
    real3 h;
    real cosine;
    condition exists;
};

HalfVector half_vector(real3 k1, real3 k2) READS {
    // Scaled by its largest part first: the square of the sum of two opposite grazing directions underflows.
    real3 sum = k1 + k2;
    real reach = max(max(abs(sum.x), abs(sum.y)), abs(sum.z));
    HalfVector between;
    between.exists = reach > real(0.0);
    sum = select(between.exists, sum / reach, real3(0.0, 0.0, 1.0));
    real size = length(sum);
    between.h = sum / size;
    between.cosine = min(real(0.5) * (size * reach), real(1.0));
    return between;
}
