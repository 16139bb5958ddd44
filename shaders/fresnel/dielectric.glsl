// Exact Fresnel equations for a dielectric of relative index ior >= 1    (Born & Wolf, sec. 1.5.2)
// An index of 1 is no surface and reflects nothing, at grazing too.
PURE real dielectric_reflectance(real ior, real cosine) {
    real refracted = sqrt(max(ior * ior - real(1.0) + cosine * cosine, real(0.0)));
    real s = (cosine - refracted) / (cosine + refracted);
    real n2 = ior * ior;
    real p = (n2 * cosine - refracted) / (n2 * cosine + refracted);
    return select(ior > real(1.0), real(0.5) * (s * s + p * p), real(0.0));
}

// a.x: index of refraction.
PURE real3 dielectric_fresnel(scalar3 a, scalar3 b, real cosine) {
    return real3(dielectric_reflectance(a.x, cosine));
}
