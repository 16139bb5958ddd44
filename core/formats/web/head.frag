#version 300 es
// The sphere's geometry as functions of a texel. A line `@part` stands for a shader of shaders/, each `@with` below it for a
// text in it and what takes its place.
precision highp float;
precision highp int;
precision highp sampler2D;

vec4 texel_place;  // in the place of gl_FragCoord: several texels make a pixel

@part geometry.glsl
@with #version 330 core =>
@with layout(location = 0) out vec4 => vec4
@with layout(location = 1) out vec4 => vec4
@part sphere.frag
@with gl_FragCoord => texel_place
@with void main() => void sphere_texel()
