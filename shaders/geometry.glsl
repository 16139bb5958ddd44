#version 330 core
// What the geometry pass leaves of the object for surface.frag, in view space: x right, y up, z toward the viewer.

uniform mat3 object_to_view;

layout(location = 0) out vec4 normal_coverage;  // w: the part of the texel that the object covers
layout(location = 1) out vec4 tangent_depth;    // orthonormal to the normal; w: z of the point

// East, along the circles of latitude about the object's y axis; at the poles any tangent serves.
vec3 east_of(vec3 normal) {
    vec3 east = cross(object_to_view[1], normal);
    float size = length(east);
    return size > 1e-6 ? east / size : object_to_view[0];
}
