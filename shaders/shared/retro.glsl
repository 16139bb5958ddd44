// Retro-reflection for any p. With T half a turn about n,
//
//   rho_r(k1, k2) = [rho(k1, T k2) + rho(T k1, k2)]/2
//
// sends light back to where a mirror would have taken it from. It is reciprocal for every p, one that is not symmetric
// under T too, and its albedo is [R(k) + R(T k)]/2. A design mixes it with its specular term by the weight surface.retro.

// T k
PURE real3 turned(real3 k) {
    return real3(-k.x, -k.y, k.z);
}

PURE Direction turned(Direction a) {
    Direction other = a;
    other.k = turned(a.k);
    other.g = a.turned_g;
    other.turned_g = a.g;
#if HAS_MULTIBOUNCE
    other.amplitude = a.turned_amplitude;
    other.rest = a.turned_rest;
    other.bounce_F = a.turned_bounce_F;
#endif
    return other;
}

// What a design makes of the specular term and of its retro-reflective form, or of the albedos of both.
real3 retro_mixed(real3 plain, real3 retro) READS {
    real3 sum = plain * real(scalar(1.0) - surface.retro) + retro * real(surface.retro);
    real most = real(LARGEST);  // which rounding may exceed
    return real3(min(sum.x, most), min(sum.y, most), min(sum.z, most));
}
