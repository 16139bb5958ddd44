    // Of light from all around, of which three.js gives the irradiance.
    if (viewer.z > 0.0) sum += {{prefix}}_albedo(viewer) * ambientLightColor / PI;
