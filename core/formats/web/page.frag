// After head.frag: Nacre's preview in one pass, without targets of floats, which not every telephone has.

@part surface.frag
@with #version 330 core =>
@with uniform sampler2D normals; =>
@with uniform sampler2D tangents; =>
@with uniform vec2 target_size; =>
@with uniform float texels_per_unit; =>
@with ivec2 texel = ivec2(gl_FragCoord.xy); =>
@with gl_FragCoord => texel_place
@with texelFetch(normals, texel, 0) => normal_coverage
@with texelFetch(tangents, texel, 0) => tangent_depth
@with out vec4 radiance; => vec4 radiance;
@with void main() => void surface_texel()

vec3 radiance_at(ivec2 texel) {
    texel_place = vec4(vec2(texel) + 0.5, 0.0, 1.0);
    sphere_texel();
    surface_texel();
    return radiance.rgb;
}

@part develop.frag
@with #version 330 core =>
@with uniform sampler2D radiance; =>
@with texelFetch(radiance, at, 0).rgb => radiance_at(at)
