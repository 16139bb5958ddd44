// After head.frag: the environment's light, a sum over samples, at the same texels.

@part accumulate.frag
@with #version 330 core =>
@with uniform sampler2D normals; =>
@with uniform sampler2D tangents; =>
@with ivec2 texel = ivec2(gl_FragCoord.xy); => texel_place = gl_FragCoord; sphere_texel(); ivec2 texel = ivec2(gl_FragCoord.xy);
@with texelFetch(normals, texel, 0) => normal_coverage
@with texelFetch(tangents, texel, 0) => tangent_depth
