// a: f0, b: depth of the dip, as a factor of c (1 - c)^6.        (Kutz, Hasan and Edmondson 2021)
PURE real3 f82_fresnel(scalar3 a, scalar3 b, real cosine) {
    real3 f0 = real3(a);
    real weight = schlick_weight(cosine);
    real3 schlick = f0 + (real3(1.0) - f0) * weight;
    return max(schlick - real3(b) * (cosine * (real(1.0) - cosine) * weight), real3(0.0));
}
