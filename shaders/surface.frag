// An object of the surface under small distant lights, seen by a distant viewer. Linear radiance.
// View space: x right, y up, z toward the viewer; all objects have a radius of about 1.

uniform sampler2D normals;      // xyz: the object's normal, view space; w: the part of the texel it covers
uniform sampler2D tangents;     // xyz: its tangent, orthonormal to that; w: z of its point
uniform vec2 target_size;       // texels
uniform float texels_per_unit;  // of view space
uniform vec3 light_direction[LIGHTS];   // toward each light, view space
uniform vec3 light_irradiance[LIGHTS];  // on a surface that faces it
#if AMBIENT_LIGHT
uniform vec3 ambient_radiance;
#endif
uniform vec3 background;  // linear radiance at the centre
uniform float falloff;    // toward the corners: 1 for a wall, 0 for the same everywhere

out vec4 radiance;

vec3 lit(Direction viewer, mat3 frame, vec3 toward, vec3 irradiance) {
    vec3 k1 = toward * frame;
    if (k1.z <= 0.0 || viewer.k.z <= 0.0) return vec3(0.0);
    return brdf_of(direction(k1), viewer) * irradiance * k1.z;
}

// The radiance toward the viewer of a surface whose tangent, bitangent and normal are the columns of `frame`,
// in view space.
vec3 shade(mat3 frame) {
    Direction viewer = direction(vec3(frame[0].z, frame[1].z, frame[2].z));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) sum += lit(viewer, frame, light_direction[i], light_irradiance[i]);
#if AMBIENT_LIGHT
    sum += total_albedo(viewer) * ambient_radiance;
#endif
    return sum;
}

// A quiet wall: brighter behind the object, falling off toward the corners.
vec3 wall(vec2 at) {
    float r2 = dot(at, at);
    return background / (1.0 + falloff * (0.35 * r2 + 0.05 * r2 * r2));
}

// What the object shows in a texel: frame, and the part of the texel that it covers. Where it covers a part but
// not the middle, the frame of a neighbour serves.
struct Seen {
    vec3 normal;
    vec3 tangent;
    float coverage;
};

Seen seen_at(ivec2 texel) {
    vec4 seen = texelFetch(normals, texel, 0);
    float coverage = seen.w;
    if (coverage > 0.0 && seen.xyz == vec3(0.0)) {
        ivec2 last = textureSize(normals, 0) - 1;
        ivec2 middle = texel;
        for (int i = 0; i < 9 && seen.xyz == vec3(0.0); ++i) {
            texel = clamp(middle + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
            seen = texelFetch(normals, texel, 0);
        }
        if (seen.xyz == vec3(0.0)) coverage = 0.0;
    }
    return Seen(seen.xyz, texelFetch(tangents, texel, 0).xyz, coverage);
}

void main() {
    vec3 colour = wall((gl_FragCoord.xy - 0.5 * target_size) / texels_per_unit);
    Seen seen = seen_at(ivec2(gl_FragCoord.xy));
    if (seen.coverage > 0.0) {
        mat3 frame = mat3(seen.tangent, cross(seen.normal, seen.tangent), seen.normal);
        colour = mix(colour, shade(frame), seen.coverage);
    }
    radiance = vec4(colour, 1.0);
}
