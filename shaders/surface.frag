// An object of the surface under small distant lights, seen by a distant viewer. Linear radiance.
// View space: x right, y up, z toward the viewer; all objects have a radius of about 1.

uniform sampler2D normals;      // xyz: the object's normal, view space; w: the part of the texel it covers
uniform sampler2D tangents;     // xyz: its tangent, orthonormal to that; w: z of its point
uniform vec2 target_size;       // texels
uniform float texels_per_unit;  // of view space
#if LIGHTS > 0
uniform vec3 light_direction[LIGHTS];   // toward each light, view space
uniform vec3 light_irradiance[LIGHTS];  // on a surface that faces it
#endif
#if AMBIENT_LIGHT
uniform vec3 ambient_radiance;
#endif
#if ENVIRONMENT_BEHIND
uniform float environment_brightness;  // factor
uniform float background_slope;  // of the view's rays, per unit of view space beside the middle
#else
uniform vec3 background;  // linear radiance at the centre
uniform float falloff;    // toward the corners: 1 for a wall, 0 for the same everywhere
#endif

out vec4 radiance;

vec3 lit(Direction viewer, mat3 frame, vec3 toward, vec3 irradiance) {
    vec3 k1 = toward * frame;
    if (k1.z <= 0.0 || viewer.k.z <= 0.0) return vec3(0.0);
#if HAS_COAT
    return shown_through_coat(direction(k1), viewer) * irradiance * k1.z;
#endif
    return shown_brdf(direction(k1), viewer) * irradiance * k1.z;
}

// The radiance (or, of the main light, the factor: see shown.glsl) toward the viewer of a surface whose tangent, bitangent and normal are the columns of `frame`,
// in view space.
vec3 shade(mat3 frame) {
    Direction viewer = direction(vec3(frame[0].z, frame[1].z, frame[2].z));
#if SHOWS_FACTOR
#if SHOWS_MASKING_2
    vec3 k1 = viewer.k;  // the light plays no part
#else
    vec3 k1 = light_direction[0] * frame;
#endif
    if (k1.z <= 0.0 || viewer.k.z <= 0.0) return vec3(0.0);
    return factor(direction(k1), viewer);
#else
    vec3 sum = vec3(0.0);
    // No loop: llvmpipe takes a quarter longer over one, even over a single light.
#if LIGHTS > 0
    sum += lit(viewer, frame, light_direction[0], light_irradiance[0]);
#endif
#if LIGHTS > 1
    sum += lit(viewer, frame, light_direction[1], light_irradiance[1]);
#endif
#if LIGHTS > 2
    sum += lit(viewer, frame, light_direction[2], light_irradiance[2]);
#endif
#if AMBIENT_LIGHT
#if HAS_COAT
    return sum + shown_coated_albedo(viewer) * ambient_radiance;
#endif
    sum += shown_albedo(viewer) * ambient_radiance;
#endif
    return sum;
#endif
}

#if ENVIRONMENT_BEHIND
// The background behind the object, seen in perspective: the object's own viewer is too far away to see more than a
// point of it.
vec3 wall(vec2 at) {
    vec3 ray = normalize(vec3(at * background_slope, -1.0));
    return environment_brightness * environment_radiance(lat_long_place(view_to_environment * ray));
}
#else
// A quiet wall: brighter behind the object, falling off toward the corners.
vec3 wall(vec2 at) {
#if SHOWS_FACTOR
    return vec3(0.0);
#endif
    float r2 = dot(at, at);
    return background / (1.0 + falloff * (0.35 * r2 + 0.05 * r2 * r2));
}
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec3 colour = wall((gl_FragCoord.xy - 0.5 * target_size) / texels_per_unit);
    vec4 seen = texelFetch(normals, texel, 0);
    if (seen.w > 0.0) {
        vec3 tangent = texelFetch(tangents, texel, 0).xyz;
        colour = mix(colour, shade(mat3(tangent, cross(seen.xyz, tangent), seen.xyz)), seen.w);
    }
    radiance = vec4(colour, 1.0);
}
