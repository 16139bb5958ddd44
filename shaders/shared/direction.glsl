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
};

// a/b of a, b >= 0, and the largest number where that is greater or b is 0; 0/b is 0 for every b.
PURE real safe_divide(real a, real b) {
    return select(a < b * LARGEST, a / b, select(a > real(0.0), real(LARGEST), real(0.0)));
}
