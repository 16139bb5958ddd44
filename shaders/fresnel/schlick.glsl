// a: f0, reflectance at normal incidence.                      (Schlick 1994; Ashikhmin 2000, eq. 31)
PURE real3 schlick_fresnel(scalar3 a, scalar3 b, real cosine) {
    real3 f0 = real3(a);
    return f0 + (real3(1.0) - f0) * schlick_weight(cosine);
}
