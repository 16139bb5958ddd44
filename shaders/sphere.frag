// A sphere of the surface under small distant lights, seen by a distant viewer. Linear radiance.
// View space: x right, y up, z toward the viewer; the sphere has radius 1.

uniform vec2 target_size;       // texels
uniform float texels_per_unit;  // of view space
uniform mat3 object_to_view;    // the sphere's own y axis is the one its tangents run about
uniform vec3 light_direction;   // toward the light, view space
uniform vec3 light_irradiance;  // on a surface that faces it
#if SECOND_LIGHT
uniform vec3 second_direction;
uniform vec3 second_irradiance;
#endif
#if AMBIENT_LIGHT
uniform vec3 ambient_radiance;
#endif
uniform vec3 background;  // linear radiance at the centre

out vec4 radiance;

// Tangents run east, along the circles of latitude; bitangents north. At the poles any frame serves.
mat3 tangent_frame(vec3 normal) {
    vec3 axis = object_to_view[1];
    vec3 east = cross(axis, normal);
    float size = length(east);
    vec3 tangent = size > 1e-6 ? east / size : object_to_view[0];
    return mat3(tangent, cross(normal, tangent), normal);
}

vec3 lit(Direction viewer, mat3 frame, vec3 toward, vec3 irradiance) {
    vec3 k1 = toward * frame;
    if (k1.z <= 0.0 || viewer.k.z <= 0.0) return vec3(0.0);
    return brdf_of(direction(k1), viewer) * irradiance * k1.z;
}

vec3 shade(vec3 normal) {
    mat3 frame = tangent_frame(normal);
    Direction viewer = direction(vec3(frame[0].z, frame[1].z, normal.z));
    vec3 sum = lit(viewer, frame, light_direction, light_irradiance);
#if SECOND_LIGHT
    sum += lit(viewer, frame, second_direction, second_irradiance);
#endif
#if AMBIENT_LIGHT
    sum += total_albedo(viewer) * ambient_radiance;
#endif
    return sum;
}

// A quiet wall: brighter behind the sphere, falling off toward the corners.
vec3 wall(vec2 at) {
    float r2 = dot(at, at);
    return background / (1.0 + 0.35 * r2 + 0.05 * r2 * r2);
}

void main() {
    vec2 at = (gl_FragCoord.xy - 0.5 * target_size) / texels_per_unit;
    float r = length(at);
    float coverage = clamp((1.0 - r) * texels_per_unit + 0.5, 0.0, 1.0);
    vec3 colour = wall(at);
    if (coverage > 0.0) {
        vec2 inside = r < 0.9999 ? at : at * (0.9999 / r);
        vec3 normal = vec3(inside, sqrt(1.0 - dot(inside, inside)));
        colour = mix(colour, shade(normal), coverage);
    }
    radiance = vec4(colour, 1.0);
}
