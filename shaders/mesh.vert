#version 330 core
// A mesh within distance 1 of the origin, as a distant viewer sees it.

uniform mat3 object_to_view;
uniform vec2 target_size;       // texels
uniform float texels_per_unit;  // of view space

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;

out vec3 view_normal;
out vec3 view_tangent;
out float depth;

void main() {
    vec3 at = object_to_view * position;
    view_normal = object_to_view * normal;
    view_tangent = object_to_view * tangent;
    depth = at.z;
    gl_Position = vec4(2.0 * texels_per_unit * at.xy / target_size, -0.9 * at.z, 1.0);
}
