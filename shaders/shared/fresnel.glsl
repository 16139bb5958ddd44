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
PURE real dielectric_fresnel(real ior, real cosine) {
    real refracted = sqrt(max(ior * ior - real(1.0) + cosine * cosine, real(0.0)));
    real s = (cosine - refracted) / (cosine + refracted);
    real n2 = ior * ior;
    real p = (n2 * cosine - refracted) / (n2 * cosine + refracted);
    return real(0.5) * (s * s + p * p);
}
#endif

#if FRESNEL_CONDUCTOR
// Exact Fresnel equations for a conductor of index eta + i kappa         (Born & Wolf, sec. 14.2)
PURE real conductor_fresnel(real eta, real kappa, real cosine) {
    real c2 = cosine * cosine;
    real s2 = real(1.0) - c2;
    real difference = eta * eta - kappa * kappa - s2;
    real a2b2 = sqrt(difference * difference + real(4.0) * eta * eta * kappa * kappa);
    real a = sqrt(max(real(0.5) * (a2b2 + difference), real(0.0)));
    real rs = (a2b2 + c2 - real(2.0) * a * cosine) / (a2b2 + c2 + real(2.0) * a * cosine);
    real tail = s2 * s2;
    real rp = (c2 * a2b2 + tail - real(2.0) * a * cosine * s2) /
              (c2 * a2b2 + tail + real(2.0) * a * cosine * s2);
    return real(0.5) * rs * (real(1.0) + rp);
}
#endif
