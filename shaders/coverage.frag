#version 330 core
// The part of each texel that a mesh covers, into the geometry buffer, of which nothing else may be written.

uniform sampler2D coverage;

layout(location = 0) out vec4 normal_coverage;

void main() {
    normal_coverage = vec4(0.0, 0.0, 0.0, texelFetch(coverage, ivec2(gl_FragCoord.xy), 0).r);
}
