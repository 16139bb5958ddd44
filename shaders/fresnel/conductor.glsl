// Exact Fresnel equations for a conductor of index eta + i kappa         (Born & Wolf, sec. 14.2)
// With a + i b = sqrt((eta + i kappa)^2 - sin^2), as quotients of sums of squares, which stay in [0, 1] however
// they are rounded:
//
//   rs = ((a - c)^2 + b^2)/((a + c)^2 + b^2),  rp/rs = ((a c - s^2)^2 + b^2 c^2)/((a c + s^2)^2 + b^2 c^2)
//
// An index of 1 is no surface and reflects nothing, at grazing too.
PURE real conductor_reflectance(real eta, real kappa, real cosine) {
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

// a: eta, b: kappa.
PURE real3 conductor_fresnel(scalar3 a, scalar3 b, real cosine) {
    return real3(conductor_reflectance(a.x, b.x, cosine), conductor_reflectance(a.y, b.y, cosine),
                 conductor_reflectance(a.z, b.z, cosine));
}
