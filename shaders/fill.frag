#version 330 core
// The geometry of a mesh as surface.frag reads it: from what stands at the middle of each texel, and from how much of it
// is covered. Where that is a part without the middle, the frame of a neighbour serves.

uniform sampler2D normals;   // as mesh.frag writes them
uniform sampler2D tangents;
uniform sampler2D coverage;

layout(location = 0) out vec4 normal_coverage;
layout(location = 1) out vec4 tangent_depth;

void main() {
    ivec2 middle = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(normals, 0) - 1;
    ivec2 texel = middle;
    vec4 normal = texelFetch(normals, texel, 0);
    float covered = texelFetch(coverage, middle, 0).r;
    if (covered > 0.0) {
        for (int i = 0; i < 9 && normal.w == 0.0; ++i) {
            texel = clamp(middle + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
            normal = texelFetch(normals, texel, 0);
        }
    }
    normal_coverage = vec4(normal.xyz, min(covered, normal.w));
    tangent_depth = texelFetch(tangents, texel, 0);
}
