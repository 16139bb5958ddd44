// The table of F in the surface's data, where it begins at fresnel_a.x.
float fetch_curve(int index) {
    return fetch(int(surface.fresnel_a.x) + index);
}
