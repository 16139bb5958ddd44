// A perfect mirror.
PURE real3 none_fresnel(scalar3 a, scalar3 b, real cosine) {
    return real3(1.0);
}
