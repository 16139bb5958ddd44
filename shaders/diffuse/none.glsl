PURE real3 none_share(Direction a) {
    return real3(0.0);
}

PURE real3 none_diffuse(Direction a, Direction b) {
    return real3(0.0);
}

PURE real3 none_diffuse_albedo(Direction a) {
    return real3(0.0);
}
