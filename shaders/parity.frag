// The BRDF of pairs of directions held in a texture: two texels a pair, k1 then k2. For tests.

uniform sampler2D pairs;

out vec4 value;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 k1 = texelFetch(pairs, ivec2(2 * at.x, at.y), 0).xyz;
    vec3 k2 = texelFetch(pairs, ivec2(2 * at.x + 1, at.y), 0).xyz;
    value = vec4(brdf(k1, k2), 1.0);
}
