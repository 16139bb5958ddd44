// Directions drawn as a plane sees them, from an order of core/light/direction_order.h: rows of 256 texels.

const int ORDER_LEVELS = 5;
const int ORDER_NODES = 1364;
const int ORDER_LEAF_SIZE = 64;

struct Drawn {
    vec3 direction;
    float weight;  // its share of the mass over the probability it was drawn with
};

vec4 order_texel(sampler2D order, int index) {
    return texelFetch(order, ivec2(index & 255, index >> 8), 0);
}

// About the mean of (d.k)+ over a range of directions: exact where all of them lie far before k or far behind, and
// positive wherever one may lie before. Were d.k Gaussian, with half of the range's variance along k, the mean at
// d.k = 0 would be this too.
float seen_part(vec4 node, vec3 k) {
    float along = dot(node.xyz, k);
    float variance = node.w * node.w / TABLE_PI;
    float root = sqrt(along * along + variance);
    if (along >= 0.0) return 0.5 * (along + root);
    return root > along ? 0.5 * variance / (root - along) : 0.0;
}

vec4 four_seen(sampler2D order, int first, vec3 k) {
    return vec4(seen_part(order_texel(order, first), k), seen_part(order_texel(order, first + 1), k),
                seen_part(order_texel(order, first + 2), k), seen_part(order_texel(order, first + 3), k));
}

// About the mean of (d.k)+ over all directions.
float all_seen(sampler2D order, vec3 k) {
    return 0.25 * dot(four_seen(order, 0, k), vec4(1.0));
}

// `at` in [0, 1) selects a direction in proportion to what k sees of it. A weight of 0: k sees none.
Drawn draw(sampler2D order, vec3 k, float at) {
    Drawn drawn = Drawn(k, 1.0);
    int range = 0;
    int first = 0;  // of the level's ranges
    for (int level = 0; level < ORDER_LEVELS; ++level) {
        vec4 parts = four_seen(order, first + 4 * range, k);
        vec4 rising = vec4(parts.x, parts.x + parts.y, parts.x + parts.y + parts.z, dot(parts, vec4(1.0)));
        float place = at * rising.w;
        int chosen = int(place >= rising.x) + int(place >= rising.y) + int(place >= rising.z);
        float part = parts[chosen];
        if (!(part > 0.0)) return Drawn(k, 0.0);
        at = clamp((place - rising[chosen] + part) / part, 0.0, 0.9999999);
        drawn.weight *= rising.w / (4.0 * part);
        range = 4 * range + chosen;
        first = 4 * first + 4;
    }
    int leaf = min(int(at * float(ORDER_LEAF_SIZE)), ORDER_LEAF_SIZE - 1);
    drawn.direction = order_texel(order, ORDER_NODES + range * ORDER_LEAF_SIZE + leaf).xyz;
    return drawn;
}
