// What the BRDF knows of one direction: its projected area and its albedo.
struct Direction {
    real3 k;
    real g;    // eq. 18
    real3 R;   // eq. 29; 0 when no diffuse term reads it
#if HAS_RETRO
    real turned_g OR_ZERO;  // of T k
    real3 retro_R OR_ZERO;  // of the retro-reflective form; R is that of the mixture
#endif
};

// a/b of a, b >= 0, and the largest number where that is greater or b is 0; 0/b is 0 for every b.
PURE real safe_divide(real a, real b) {
    return select(a < b * LARGEST, a / b, select(a > real(0.0), real(LARGEST), real(0.0)));
}
