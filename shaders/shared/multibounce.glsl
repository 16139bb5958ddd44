// Light that leaves after two or more bounces between facets, 1/sr:
//
//   rho(k1, k2) = F(k1) F(k2) C [M(k1, k2) + e(k1) e(k2)/(pi <e>)]
//
// M is a model's of shaders/multibounce/, e = 1 - E - (what M brings), E = R with F = 1, is what it leaves: it is spread evenly
// (Kulla & Conty 2017), so that facets that reflect everything lose nothing. F(k) is the mean Fresnel factor of the facets
// whose light stays between them. C = e2/(1 - Fm (1 - e2)) stands for the bounces between the first and the last, whose mean
// factor is Fm: of the light that leaves after two or more, the part e2 leaves after each.

// a with what its bounces need; kept = g/G.
Direction with_bounces(Direction a, AlbedoSpot spot, real kept) READS {
    real one = real(0.0);
    real3 spread = real3(0.0);
    a.amplitude = real(0.0);
#define MULTIBOUNCE_CASE(index, amplitude_of, row_of, spread_of, kernel_of) if (MULTIBOUNCE_IS(index)) { a.amplitude = amplitude_of(a.k); one = row_of(spot); spread = spread_of(spot, one); }
EACH_MULTIBOUNCE
#undef MULTIBOUNCE_CASE
    a.rest = max(real(1.0) - bounce_whole(spot) * kept - a.amplitude * one, real(0.0));
    a.bounce_F = bounce_factor(spot);
    a.M = a.bounce_F * surface.bounce_scale * (spread * a.amplitude + real3(surface.bounce_mean) * a.rest);
    return a;
}

real3 multibounce(Direction a, Direction b) READS {
    if (!BOUNCES) return real3(0.0);
    real m = real(0.0);
#define MULTIBOUNCE_CASE(index, amplitude_of, row_of, spread_of, kernel_of) if (MULTIBOUNCE_IS(index)) m = kernel_of(a, b);
EACH_MULTIBOUNCE
#undef MULTIBOUNCE_CASE
    return (a.bounce_F * b.bounce_F) * real3(surface.bounce_scale) * (m + (a.rest * b.rest) * surface.bounce_even);
}
