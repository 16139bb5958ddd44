#version 330 core
// From linear radiance at several texels a pixel to a picture: exposure, a filmic curve, sRGB and a dither
// that keeps smooth gradients from banding in 8 bits; or the plain mean when `linear` is set. A factor of the
// BRDF in the place of radiance becomes colours that stand for numbers: one with colours of its own as it is,
// a plain number through a colour map.

uniform sampler2D radiance;
uniform sampler2D accumulated;  // of the environment: a sum of samples, and their number
uniform bool has_environment;
uniform int supersample;  // texels a pixel, each way
uniform float exposure;   // factor
uniform bool linear;
uniform bool is_factor;
uniform bool coloured;     // factor: with colours of its own
uniform bool logarithmic;  // factor: from `low` to `high`; otherwise from 0
uniform float low;
uniform float high;
uniform sampler2D colours;  // the colour map, one row, sRGB

out vec4 picture;

// Hable (2010): a toe that keeps dark colours apart and a long shoulder; 1 at five and a half times white.
vec3 filmic_curve(vec3 x) {
    return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
}

vec3 filmic(vec3 x) { return clamp(filmic_curve(2.0 * x) / filmic_curve(vec3(11.2)), 0.0, 1.0); }

// IEC 61966-2-1.
vec3 srgb(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-8), vec3(1.0 / 2.4)) - 0.055,
               greaterThan(c, vec3(0.0031308)));
}

// A hash of the pixel in [0, 1), the same in every run.
float noise(uvec2 pixel, uint channel) {
    uint x = pixel.x * 1664525u + pixel.y * 22695477u + channel * 2891336453u + 1013904223u;
    x = (x ^ (x >> 16)) * 2246822519u;
    x = (x ^ (x >> 13)) * 3266489917u;
    return float((x ^ (x >> 16)) >> 8) / 16777216.0;
}

vec3 factor_colour(vec3 value) {
    if (coloured) return srgb(clamp(value / high, 0.0, 1.0));
    float place = logarithmic ? log(max(value.x, low) / low) / log(high / low) : value.x / high;
    float size = float(textureSize(colours, 0).x);
    return texture(colours, vec2((clamp(place, 0.0, 1.0) * (size - 1.0) + 0.5) / size, 0.5)).rgb;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < supersample; ++j) {
        for (int i = 0; i < supersample; ++i) {
            ivec2 at = pixel * supersample + ivec2(i, j);
            vec3 texel = texelFetch(radiance, at, 0).rgb;
            if (has_environment) {
                vec4 light = texelFetch(accumulated, at, 0);
                texel += light.rgb / max(light.a, 1.0);
            }
            texel *= exposure;
            sum += linear || is_factor ? texel : filmic(texel);
        }
    }
    vec3 colour = sum / float(supersample * supersample);
    if (is_factor) colour = factor_colour(colour);
    if (!linear && !is_factor) {
        uvec2 p = uvec2(pixel);
        vec3 triangle =
            vec3(noise(p, 0u) - noise(p, 3u), noise(p, 1u) - noise(p, 4u), noise(p, 2u) - noise(p, 5u));
        colour = srgb(colour) + 0.5 * triangle / 255.0;
    }
    picture = vec4(colour, 1.0);
}
