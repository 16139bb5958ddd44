PURE real3 evenly_share(Direction a) {
    return real3(1.0);
}

real3 evenly_diffuse(Direction a, Direction b) READS {
    return real3(surface.albedo * (surface.kd / TABLE_PI));
}

real3 evenly_diffuse_albedo(Direction a) READS {
    return real3(surface.albedo * surface.kd);
}
