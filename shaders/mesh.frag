// The geometry of a mesh. Both of its sides are seen.

in vec3 view_normal;
in vec3 view_tangent;
in float depth;

const float least_facing = 0.01;  // of the normal's z

void main() {
    vec3 normal = normalize(gl_FrontFacing ? view_normal : -view_normal);
    // Between vertices near an outline the mean of the normals may turn away from the viewer, as no visible
    // surface does.
    if (normal.z < least_facing) normal = normalize(vec3(normal.xy, least_facing));
    vec3 tangent = view_tangent - normal * dot(normal, view_tangent);
    float size = length(tangent);
    normal_coverage = vec4(normal, 1.0);
    tangent_depth = vec4(size > 1e-3 ? tangent / size : east_of(normal), depth);
}
