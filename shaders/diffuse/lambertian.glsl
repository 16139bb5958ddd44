PURE real3 lambertian_share(Direction a) {
    return real3(1.0);
}

// kd albedo/pi                                                               (Ashikhmin 2000, eq. 27)
real3 lambertian_diffuse(Direction a, Direction b) READS {
    return real3(surface.albedo * (surface.kd / TABLE_PI));
}

real3 lambertian_diffuse_albedo(Direction a) READS {
    return real3(surface.albedo * surface.kd);
}
