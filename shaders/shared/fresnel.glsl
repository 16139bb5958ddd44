// What the models of shaders/fresnel/ share. Each is the reflectance of a facet, `cosine` = k.h in [0, 1], unpolarised, from
// air: real3 NAME_fresnel(scalar3 a, scalar3 b, real cosine).

// (1 - cosine)^5                                              (Schlick 1994; Ashikhmin 2000, eq. 31)
PURE real schlick_weight(real cosine) {
    real m = real(1.0) - cosine;
    real m2 = m * m;
    return m2 * m2 * m;
}
