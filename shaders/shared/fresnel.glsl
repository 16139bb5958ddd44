// Fresnel reflectance of a facet, `cosine` = k.h in [0, 1]. Unpolarised, from air.

#if FRESNEL_SCHLICK
// (1 - cosine)^5                                              (Schlick 1994; Ashikhmin 2000, eq. 31)
PURE real schlick_weight(real cosine) {
    real m = real(1.0) - cosine;
    real m2 = m * m;
    return m2 * m2 * m;
}
#endif

#if FRESNEL_SCHLICK
PURE real3 schlick_fresnel(real3 f0, real cosine) {
    return f0 + (real3(1.0) - f0) * schlick_weight(cosine);
}
#endif

#if FRESNEL_DIELECTRIC
// Exact Fresnel equations for a dielectric of relative index ior >= 1    (Born & Wolf, sec. 1.5.2)
// An index of 1 is no surface and reflects nothing, at grazing too.
PURE real dielectric_fresnel(real ior, real cosine) {
    real refracted = sqrt(max(ior * ior - real(1.0) + cosine * cosine, real(0.0)));
    real s = (cosine - refracted) / (cosine + refracted);
    real n2 = ior * ior;
    real p = (n2 * cosine - refracted) / (n2 * cosine + refracted);
    return select(ior > real(1.0), real(0.5) * (s * s + p * p), real(0.0));
}
#endif

#if FRESNEL_CONDUCTOR
// Exact Fresnel equations for a conductor of index eta + i kappa         (Born & Wolf, sec. 14.2)
// With a + i b = sqrt((eta + i kappa)^2 - sin^2), as quotients of sums of squares, which stay in [0, 1] however
// they are rounded:
//
//   rs = ((a - c)^2 + b^2)/((a + c)^2 + b^2),  rp/rs = ((a c - s^2)^2 + b^2 c^2)/((a c + s^2)^2 + b^2 c^2)
//
// An index of 1 is no surface and reflects nothing, at grazing too.
PURE real conductor_fresnel(real eta, real kappa, real cosine) {
    real index = (eta - real(1.0)) * (eta + real(1.0)) - kappa * kappa;
    real loss = real(2.0) * eta * kappa;
    real c2 = cosine * cosine;
    real s2 = real(1.0) - c2;
    real difference = index + c2;
    real a2b2 = sqrt(difference * difference + loss * loss);
    real a = sqrt(max(real(0.5) * (a2b2 + difference), real(0.0)));
    real b2 = max(real(0.5) * (a2b2 - difference), real(0.0));
    real below = a - cosine;
    real above = a + cosine;
    real rs = (below * below + b2) / (above * above + b2);
    below = a * cosine - s2;
    above = a * cosine + s2;
    real rp = (below * below + b2 * c2) / (above * above + b2 * c2);
    return select(index == real(0.0) && loss * loss == real(0.0), real(0.0), real(0.5) * rs * (real(1.0) + rp));
}
#endif
