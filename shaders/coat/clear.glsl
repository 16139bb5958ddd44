// Beckmann's facets, <n.h> = 1, at a cosine from n                        (Walter et al. 2007, eq. 25)
PURE real clear_density(scalar width, real cosine) {
    real c2 = max(cosine * cosine, real(1e-12));
    scalar square = width * width;
    return exp((real(1.0) - real(1.0) / c2) / real(square)) / (real(TABLE_PI * square) * c2 * c2);
}

// Their projected area toward k, c (1 + erf(a))/2 + width s exp(-a^2)/(2 sqrt(pi)), a = c/(width s); the error function within
// 1.5e-7                                                        (Abramowitz & Stegun 1964, eq. 7.1.26)
PURE real clear_area(scalar width, real cosine) {
    real sine = sqrt(max(real(1.0) - cosine * cosine, real(0.0)));
    real across = real(width) * sine;
    real t = across / (across + real(0.3275911) * cosine);
    real a = cosine / max(across, real(1e-9));
    real bell = exp(-min(a * a, real(80.0)));
    real tail = t * (real(0.254829592) + t * (real(-0.284496736) + t * (real(1.421413741) + t * (real(-1.453152027) + t * real(1.061405429)))));
    return cosine * (real(1.0) - real(0.5) * tail * bell) + across * bell * real(0.28209479177387814);
}
