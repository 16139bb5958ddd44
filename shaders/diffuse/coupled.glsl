// c albedo (1 - R(k1)) (1 - R(k2))                                           (Ashikhmin 2000, eq. 28)
PURE real3 coupled_share(Direction a) {
#if HAS_MULTIBOUNCE
    a.R = a.R + a.M;
#endif
    return max(real3(1.0) - a.R, real3(0.0));
}

real3 coupled_diffuse(Direction a, Direction b) READS {
    return (coupled_share(a) * coupled_share(b)) * (surface.coupling * surface.albedo);
}

// The constant c of eq. 28 makes it the share times the albedo.
real3 coupled_diffuse_albedo(Direction a) READS {
    return coupled_share(a) * surface.albedo;
}
