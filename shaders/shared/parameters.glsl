// What a surface is made of, as the shader and core read it. Compiled as GLSL 3.30 and, inside the structs of
// core/model/shading.h and core/model/lane_shading-inl.h, as C++ for one direction and for many at once: a `scalar`
// and an int are the same for all directions, a `real`, an `integer` and a `condition` may differ.

CONSTANT int SYMMETRY_ISOTROPIC = 0;  // p depends on theta alone
CONSTANT int SYMMETRY_QUARTER = 1;    // two mirror planes
CONSTANT int SYMMETRY_HALF = 2;       // one
CONSTANT int SYMMETRY_NONE = 3;

// One layer of p. Offsets count floats in the surface's data.
struct Layer {
    int kind;          // which lobe of shaders/lobes/, in the order of their list
    scalar scale;        // density = scale * lobe (share of area over the lobe's own integral)
    scalar3 axis_x;      // the lobe's frame, in the local frame of the surface
    scalar3 axis_y;
    scalar3 axis_z;
    scalar2 inverse_width;   // 1/sigma or 1/alpha along x and y; 0 for an infinite width
    int data_offset;   // curve: (theta, value) pairs; painted: texels, top row first
    int data_size;     // curve: points; painted: texels a side; uniform: 1 for the whole sphere
    int picture_offset;    // modulation: texels, top row first
    int picture_size;      // texels a side; 0 without modulation
    scalar picture_strength;
#if HAS_TINT
    scalar3 tint;      // reflectance of the layer's facets besides F
#endif
};

// The baked tables' shape; see tables.glsl.
struct TableShape {
    scalar g_normal;  // g(n)
    scalar2 moment;   // along the tangent and bitangent: of what is linear in k and left out of the table of g
    scalar2 axis;     // cos and sin of the azimuth that the tables are aligned with
    scalar2 stretch;  // widths of p along that axis and across it
    scalar lean;      // -1 to 1: how much denser rows are opposite to that axis
    int symmetry;   // SYMMETRY_*
    int nodes_w;      // along theta, for g
    int nodes_v;      // along theta, for R
    int nodes_psi;    // along azimuth, for g
    int nodes_rho;    // along azimuth, for R
    int area_offset;      // nodes_psi rows of nodes_w
    int albedo_offset;    // nodes_rho rows of nodes_v
    int residual_offset;  // the same, once or three times
#if HAS_MULTIBOUNCE
    int row_offset;         // at R's nodes: what a fitted model brings, over its amplitude
    int factor_offset;      // at R's nodes: the mean Fresnel factor of light that bounces on, in BOUNCE_FACTORS tables
    int spread_offset;      // at R's nodes: the same, times the factor at the other end, in as many
    int whole_offset;       // at R's nodes: E where tints differ
    int amplitude_offset;   // of a fitted model: its table over one direction
    int sum_offset;         // over the sum of both
    int difference_offset;  // and over their difference
    int momentum_nodes;     // of these three, from 0 to 2
#endif
#if HAS_MATT_FACETS
    int facet_offset;   // facet_classes facet_terms + 1 tables: u of each term, then E; see matt_facets.glsl
    int facet_nodes;    // along w
    int facet_rows;     // along psi
    int facet_classes;
    int facet_terms;    // of each class
#endif
#if HAS_COAT
    int coat_offset;        // R_c, then u and b, each colour
    int coat_albedo_nodes;  // of R_c
    int coat_nodes;         // of u and b, in the root of the cosine outside
    int coat_rows;          // along azimuth
#endif
};

struct Surface {
    TableShape tables;
    scalar N;             // <n.h> times the design's mean_cosine_scale
    scalar masking_width; // correlated masking: standard deviation of t(phi), radians (eq. 14)
    scalar3 fresnel_a;    // what the Fresnel model reads: f0; the index of refraction in x; eta
    scalar3 fresnel_b;    // kappa
    scalar kd;            // eq. 27
    scalar ks;            // weight of the specular term: the design's intensity, times that of eq. 27
    scalar3 albedo;       // rho_d
    scalar3 coupling;     // the constant c of eq. 28, for each colour
#if HAS_MULTIBOUNCE
    scalar3 bounce_scale; // C of multibounce.glsl
    scalar3 bounce_mean;  // F(k) in the mean over e
    scalar bounce_even;   // 1/(pi <e>)
#endif
#if HAS_MATT_FACETS
    scalar3 facet_scale;  // albedo of two and more bounces between matt facets, of the light that they keep
    scalar facet_even;    // 1/(pi <1 - E>)
#endif
#if HAS_RETRO
    scalar retro;         // weight of retro-reflection in the specular term
#endif
#if HAS_COAT
    scalar coat_width;    // of its own facets
    scalar coat_ior;
    scalar3 coat_depth;   // optical depth of one way through it along n
    scalar3 coat_even;    // 1/E of coat.glsl
#endif
};
