// The paper's metal: ones of eq. 28 become f0, and the albedo is f0.           (Ashikhmin 2000, eq. 30)
real3 metal_share(Direction a) READS {
    return max(surface.albedo - a.R, real3(0.0));
}

real3 metal_diffuse(Direction a, Direction b) READS {
    return (metal_share(a) * metal_share(b)) * (surface.coupling * surface.albedo);
}

real3 metal_diffuse_albedo(Direction a) READS {
    return metal_share(a) * surface.albedo;
}
