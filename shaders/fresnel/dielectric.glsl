// Exact Fresnel equations for a dielectric of relative index ior          (Born & Wolf, sec. 1.5.2)
// Below 1 it reflects all beyond the critical angle, where `below` is 0. An index of 1 is no surface and reflects nothing, at
// grazing too.
PURE real dielectric_reflectance(real ior, real cosine) {
    real below = sqrt(max(ior * ior - real(1.0) + cosine * cosine, real(0.0)));
    real s = (cosine - below) / (cosine + below);
    real n2 = ior * ior;
    real p = (n2 * cosine - below) / (n2 * cosine + below);
    real reflected = select(below > real(0.0), real(0.5) * (s * s + p * p), real(1.0));
    return select(ior == real(1.0), real(0.0), reflected);
}

// a.x: index of refraction.
PURE real3 dielectric_fresnel(scalar3 a, scalar3 b, real cosine) {
    return real3(dielectric_reflectance(a.x, cosine));
}
