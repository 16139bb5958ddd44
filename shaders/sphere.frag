// The geometry of a sphere of radius 1 about the origin. Exact at each texel; at its edge the part of the texel
// that it covers.

uniform vec2 target_size;       // texels
uniform float texels_per_unit;  // of view space

void main() {
    vec2 at = (gl_FragCoord.xy - 0.5 * target_size) / texels_per_unit;
    float r = length(at);
    float coverage = clamp((1.0 - r) * texels_per_unit + 0.5, 0.0, 1.0);
    vec2 inside = r < 0.9999 ? at : at * (0.9999 / r);
    vec3 normal = vec3(inside, sqrt(1.0 - dot(inside, inside)));
    normal_coverage = vec4(normal, coverage);
    tangent_depth = vec4(east_of(normal), normal.z);
}
