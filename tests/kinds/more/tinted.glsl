PURE real3 tinted_fresnel(scalar3 a, scalar3 b, real cosine) {
    return real3(a);
}
