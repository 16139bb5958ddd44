#version 330 core
// The geometry of a sphere of radius 1 about the origin of view space (x right, y up, z toward the viewer), as
// surface.frag reads it. Exact at each texel; at its edge the part of the texel that it covers.

uniform vec2 target_size;       // texels
uniform float texels_per_unit;  // of view space
uniform mat3 object_to_view;    // the sphere's own y axis is the one its tangents run about

layout(location = 0) out vec4 normal_coverage;
layout(location = 1) out vec4 tangent_depth;

// Tangents run east, along the circles of latitude; at the poles any serves.
vec3 tangent_of(vec3 normal) {
    vec3 east = cross(object_to_view[1], normal);
    float size = length(east);
    return size > 1e-6 ? east / size : object_to_view[0];
}

void main() {
    vec2 at = (gl_FragCoord.xy - 0.5 * target_size) / texels_per_unit;
    float r = length(at);
    float coverage = clamp((1.0 - r) * texels_per_unit + 0.5, 0.0, 1.0);
    vec2 inside = r < 0.9999 ? at : at * (0.9999 / r);
    vec3 normal = vec3(inside, sqrt(1.0 - dot(inside, inside)));
    normal_coverage = vec4(normal, coverage);
    tangent_depth = vec4(tangent_of(normal), normal.z);
}
