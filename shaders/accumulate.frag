// Light of the environment that the object reflects toward a distant viewer: a sum over samples, to be added to
// those before. A sample draws one visible facet of p and one direction of light, and weighs both by the balance
// heuristic (Veach & Guibas 1995), so that neither a narrow p nor a small sun is missed.

uniform sampler2D normals;  // as in surface.frag
uniform sampler2D tangents;
uniform sampler2D facet_order;
uniform sampler2D light_order;
uniform float light_scale;  // from the picture's radiance to the density that light is drawn with, 1/sr
uniform int first_sample;
uniform int samples;

uniform float environment_brightness;  // factor

out vec4 accumulated;  // radiance times coverage, and the number of samples

#if HAS_RETRO
// How densely the facets that k2 sees send it into k1, 1/sr.
float mirrored_density(vec3 k2, float g, vec3 k1) {
    vec3 sum = k1 + k2;
    return g > 0.0 ? density(sum / length(sum)) / (4.0 * g) : 0.0;
}

#endif
// How densely the facets that the viewer sees send it into k1, 1/sr.
float facet_density_of(Direction viewer, vec3 k1) {
#if HAS_COAT
    float leaving = k1.z;
    k1 = refracted(k1);
    leaving /= surface.coat_ior * surface.coat_ior * k1.z;
#endif
    vec3 sum = k1 + viewer.k;
    float by_facets = viewer.g > 0.0 ? density(sum / length(sum)) / (4.0 * viewer.g) : 0.0;
#if HAS_RETRO
    by_facets = mix(by_facets, 0.5 * (mirrored_density(turned(viewer.k), viewer.turned_g, k1) +
                                      mirrored_density(viewer.k, viewer.g, turned(k1))), surface.retro);
#endif
#if HAS_COAT
    by_facets *= leaving;
#endif
    return by_facets;
}

#if HAS_COAT
// The coat's own facets are drawn as Beckmann's of their width: slopes by a bell.
vec3 coat_facet(vec2 at) {
    float slope = surface.coat_width * sqrt(-log(max(1.0 - at.x, 1e-7)));
    float phi = 2.0 * TABLE_PI * at.y;
    return normalize(vec3(slope * cos(phi), slope * sin(phi), 1.0));
}

// How densely they send the viewer into k1, 1/sr.
float coat_density_of(Direction viewer, vec3 k1) {
    vec3 sum = k1 + viewer.outside;
    vec3 h = sum / length(sum);
    float c2 = h.z * h.z;
    float square = surface.coat_width * surface.coat_width;
    float drawn = exp((1.0 - 1.0 / c2) / square) / (TABLE_PI * square * c2 * h.z);
    return drawn / (4.0 * max(dot(viewer.outside, h), 1e-6));
}

#endif
// rho L (k1.n) over the sum of the densities, in which each way may draw k1: visible facets, light, and a coat's own
// facets. That is each way's own quotient times its weight by the balance heuristic.
vec3 reflected(Direction viewer, vec3 k1, vec3 toward, float irradiance) {
    vec2 place = lat_long_place(toward);
    vec3 light = environment_radiance(place);
    float by_light = irradiance > 0.0 ? dot(light, vec3(light_scale)) * k1.z / irradiance : 0.0;
    float both = by_light + facet_density_of(viewer, k1);
#if HAS_COAT
    both += coat_density_of(viewer, k1);
#endif
    if (!(both > 0.0)) return vec3(0.0);
#if HAS_COAT
    return shown_through_coat(direction(k1), viewer) * light * (k1.z / both);
#endif
    return shown_brdf(direction(k1), viewer) * light * (k1.z / both);
}

vec3 by_facet(Direction viewer, mat3 to_environment, float irradiance, float at) {
    Direction seen = viewer;  // whose facets are drawn
#if HAS_RETRO
    // One of the ways, and `at` anew in it: T before a facet mirrors, after it, or neither.
    float each = 0.5 * surface.retro;
    bool before = at < each;
    bool after = !before && at < surface.retro;
    at = before ? at / each : after ? (at - each) / each : (at - surface.retro) / (1.0 - surface.retro);
    at = clamp(at, 0.0, 0.9999999);
    if (before) seen = turned(viewer);
#endif
    if (!(seen.g > 0.0)) return vec3(0.0);
    Drawn facet = draw(facet_order, seen.k, at);
    float kh = dot(seen.k, facet.direction);
    vec3 k1 = normalize(2.0 * kh * facet.direction - seen.k);
#if HAS_RETRO
    if (after) k1 = turned(k1);
#endif
    if (facet.weight <= 0.0 || kh <= 0.0 || k1.z <= 0.0) return vec3(0.0);
#if HAS_COAT
    k1 = emerging(k1);
    if (k1.z <= 0.0) return vec3(0.0);
#endif
    return reflected(viewer, k1, to_environment * k1, irradiance) * (facet.weight * kh / seen.g);
}

vec3 by_light(Direction viewer, mat3 to_environment, float irradiance, float at) {
    Drawn light = draw(light_order, to_environment[2], at);
    vec3 k1 = light.direction * to_environment;
    if (light.weight <= 0.0 || k1.z <= 0.0) return vec3(0.0);
    return reflected(viewer, k1, light.direction, irradiance) * (light.weight * k1.z / irradiance);
}

#if HAS_COAT
vec3 by_coat(Direction viewer, mat3 to_environment, float irradiance, vec2 at) {
    vec3 h = coat_facet(at);
    vec3 k1 = 2.0 * dot(viewer.outside, h) * h - viewer.outside;
    if (dot(viewer.outside, h) <= 0.0 || k1.z <= 0.0) return vec3(0.0);
    return reflected(viewer, k1, to_environment * k1, irradiance);
}

#endif
// Base 2: sample number i of van der Corput's sequence (1935).
float radical_inverse(uint i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
    i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
    i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
    i = ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
    return float(i >> 8) / 16777216.0;
}

// Where a texel's sequence begins, so that neighbours err apart (Cranley & Patterson 1976): a hash of its
// place, the same in every run.
float turn(uvec2 texel) {
    uint x = texel.x * 1664525u + texel.y * 22695477u + 1013904223u;
    x = (x ^ (x >> 16)) * 2246822519u;
    x = (x ^ (x >> 13)) * 3266489917u;
    return float((x ^ (x >> 16)) >> 8) / 16777216.0;
}

void main() {
    accumulated = vec4(0.0, 0.0, 0.0, float(samples));
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 seen = texelFetch(normals, texel, 0);
    if (seen.w <= 0.0 || seen.z <= 0.0) return;
    vec3 tangent = texelFetch(tangents, texel, 0).xyz;
    mat3 frame = mat3(tangent, cross(seen.xyz, tangent), seen.xyz);
    Direction viewer = direction(vec3(frame[0].z, frame[1].z, frame[2].z));
    mat3 to_environment = view_to_environment * frame;
    float irradiance = all_seen(light_order, to_environment[2]);
    float start = turn(uvec2(texel));
    vec3 sum = vec3(0.0);
    for (int i = first_sample; i < first_sample + samples; ++i) {
        float at = fract(start + radical_inverse(uint(i)));
        sum += by_facet(viewer, to_environment, irradiance, at);
        sum += by_light(viewer, to_environment, irradiance, fract(at + 0.5));
#if HAS_COAT
        // Roberts 2018: a second sequence beside the first.
        sum += by_coat(viewer, to_environment, irradiance, vec2(at, fract(start + 0.6180339887 * float(i))));
#endif
    }
    accumulated.rgb = environment_brightness * sum * seen.w;
}
