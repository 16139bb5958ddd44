// The geometry pass's textures.

uniform sampler2D normals;   // xyz: the object's normal, view space; w: the part of the texel it covers
uniform sampler2D tangents;  // xyz: its tangent, orthonormal to that; w: z of its point

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
