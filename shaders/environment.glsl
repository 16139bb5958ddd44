// The lat-long environment map; core/image/lat_long.h says which way is which.

uniform sampler2D environment_picture;  // radiance; row 0 touches the zenith
uniform mat3 view_to_environment;

// As fractions of the picture's width and height, from the left and from the top.
vec2 lat_long_place(vec3 direction) {
    float level = length(direction.xz);
    float u = level > 0.0 ? atan(direction.x, -direction.z) / (2.0 * TABLE_PI) : 0.0;
    return vec2(u + 0.5, atan(level, direction.y) / TABLE_PI);
}

vec3 environment_texel(ivec2 at, ivec2 size) {
    return texelFetch(environment_picture, ivec2((at.x + size.x) % size.x, min(at.y, size.y - 1)), 0).rgb;
}

// Bilinear, written out: a filter of the hardware has 8 bits of fraction.
vec3 environment_radiance(vec2 place) {
    ivec2 size = textureSize(environment_picture, 0);
    vec2 at = place * vec2(size) - 0.5;
    at.y = clamp(at.y, 0.0, float(size.y) - 1.0);
    ivec2 texel = ivec2(floor(at));
    vec2 part = at - floor(at);
    vec3 top = mix(environment_texel(texel, size), environment_texel(texel + ivec2(1, 0), size), part.x);
    vec3 bottom = mix(environment_texel(texel + ivec2(0, 1), size), environment_texel(texel + ivec2(1, 1), size),
                      part.x);
    return mix(top, bottom, part.y);
}
