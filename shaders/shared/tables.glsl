// The projected area g(k) and the albedo R(k) from tables whose directions are stretched by p's own width,
// so that their error does not depend on how narrow p is.
//
//   g(k) = (kx, ky).m + (c g(n) + 2 q) A(w, psi),   q = |L (kx, ky)|: an ellipse through p's width <|h.k|>/2 at
//                                                   grazing
//   w = 2 q / (c g(n) + 2 q),   psi = azimuth after that ellipse is made a circle, in quarter turns (see
//                               quarter_turns())
//
// c g(n) + 2 q is what g is near the normal and, where <h> is along n, about twice what it is at grazing: A is 1
// at the normal (w = 0) and, with m = 0, about 1/2 there (w = 1). Straight lines in w are chords of the homogeneous,
// convex g on a meridian, and exact for what is linear in k. m is 0, or for a tilted p the horizontal part of
// the integral of h p over the facets above the horizon, whichever has the smaller error: where facets turn away all
// at once, as those of a tilted needle, g is linear before; where they do so gradually, m.k and the rest would
// cancel, and rows that are denser there serve better (table_turns).
//
// R also turns at the scale of the hemisphere itself (Fresnel, a lobe that is narrow one way and wide the
// other), so its tables share their nodes between both scales:
//
//   v = (w + sin(theta)/(c + sin(theta)))/2,   rho = (psi + phi)/2, phi in quarter turns too
//
// What they hold is the mean of F V over the facets that k sees, R G/g with G = max(g, N c): it stays smooth where
// the clamp cuts in.
//
// Tables are bilinear; nodes are on both ends in w and v, and in psi and rho on both ends of a folded range.

CONSTANT scalar TABLE_PI = scalar(3.14159265358979323846);

// Two neighbouring rows of a table and a place between them.
struct TableRows {
    integer first;
    integer second;
    real fraction;
};

// Where k lies in the table of g.
struct TableSpot {
    TableRows psi;
    real w;
    real q;
    real scale;     // c g(n) + 2 q
    real2 azimuth;  // k from the tables' axis, folded; its length is sin(theta)
    real turns;     // psi
};

// Where k lies in the tables of R.
struct AlbedoSpot {
    TableRows rho;
    real v;
};

// The azimuth of (x, y) in quarter turns, in [0, 4]: exact at every eighth of a turn and within 0.009 between
// them. Every table reads its rows by it, so that no arc tangent is needed: within a quarter, with
// t = (y - x)/(y + x), the angle is pi/4 (1 + (4/pi) atan(t)), approximated by the cubic t (6 - t^2)/5,
// because rows then lie evenly to 6 %.
PURE real quarter_turns(real x, real y) {
    real sum = abs(x) + abs(y);
    real t = select(sum > real(0.0), (abs(y) - abs(x)) / sum, real(-1.0));
    real turns = real(0.5) + t * (real(0.6) - real(0.1) * t * t);
    turns = select(x < real(0.0), real(2.0) - turns, turns);
    return select(y < real(0.0), real(4.0) - turns, turns);
}

// `turns` is an azimuth in the folded range: [0, 1], [0, 2] or [0, 4] for the whole circle.
TableRows table_rows(real turns, int nodes) READS {
    int symmetry = surface.tables.symmetry;
    real place = real(0.0);
    if (symmetry == SYMMETRY_QUARTER) place = turns * real(nodes - 1);
    if (symmetry == SYMMETRY_HALF) place = real(0.5) * turns * real(nodes - 1);
    if (symmetry == SYMMETRY_NONE) place = real(0.25) * turns * real(nodes);
    TableRows rows;
    rows.first = min(integer(place), nodes - 1);
    rows.second = rows.first + 1;
    integer past = rows.first;
    if (symmetry == SYMMETRY_NONE) past = integer(0);
    rows.second = select(rows.second == nodes, past, rows.second);
    rows.fraction = place - real(rows.first);
    return rows;
}

// psi of (x, y) from the tables' axis. A tilted p turns away within a narrow range of azimuths: rows are
// denser there, by the formula of stellar aberration, before p's width is made one.
real table_turns(real x, real y) READS {
    scalar lean = surface.tables.lean;
    real along = x;
    real across = y;
    if (lean != scalar(0.0)) {
        along = x + lean * sqrt(x * x + y * y);
        across = y * sqrt(scalar(1.0) - lean * lean);
    }
    return quarter_turns(surface.tables.stretch.x * along, surface.tables.stretch.y * across);
}

TableSpot table_spot(real3 k) READS {
    int symmetry = surface.tables.symmetry;
    real x = surface.tables.axis.x * k.x + surface.tables.axis.y * k.y;
    real y = surface.tables.axis.x * k.y - surface.tables.axis.y * k.x;
    if (symmetry == SYMMETRY_QUARTER) x = abs(x);
    if (symmetry == SYMMETRY_QUARTER || symmetry == SYMMETRY_HALF) y = abs(y);
    real along = surface.tables.stretch.x * x;
    real across = surface.tables.stretch.y * y;
    TableSpot spot;
    spot.azimuth = real2(x, y);
    spot.turns = real(0.0);
    if (symmetry != SYMMETRY_ISOTROPIC) spot.turns = table_turns(x, y);
    spot.psi = table_rows(spot.turns, surface.tables.nodes_psi);
    spot.q = sqrt(along * along + across * across);
    spot.scale = k.z * surface.tables.g_normal + real(2.0) * spot.q;
    spot.w = select(spot.scale > real(0.0), min(real(2.0) * spot.q / spot.scale, real(1.0)), real(0.0));
    return spot;
}

#if HAS_ALBEDO
AlbedoSpot albedo_spot(real3 k, TableSpot spot) READS {
    AlbedoSpot albedo;
    albedo.rho = spot.psi;
    if (surface.tables.symmetry != SYMMETRY_ISOTROPIC) {
        real turns = real(0.5) * (spot.turns + quarter_turns(spot.azimuth.x, spot.azimuth.y));
        albedo.rho = table_rows(turns, surface.tables.nodes_rho);
    }
    real sine = length(spot.azimuth);
    albedo.v = min(real(0.5) * (spot.w + sine / (k.z + sine)), real(1.0));
    return albedo;
}
#endif

// A table whose rows hold `nodes` values, at `at` in [0, 1] along them.
real table_value(TableRows rows, int offset, int nodes, real at) READS {
    real place = at * real(nodes - 1);
    integer column = min(integer(place), nodes - 2);
    real s = place - real(column);
    integer a = offset + rows.first * nodes + column;
    integer b = offset + rows.second * nodes + column;
    real first = fetch(a) * (real(1.0) - s) + fetch(a + 1) * s;
    real second = fetch(b) * (real(1.0) - s) + fetch(b + 1) * s;
    return first * (real(1.0) - rows.fraction) + second * rows.fraction;
}

// g at a spot, p normalised to 1                                     (Ashikhmin 2000, eq. 18)
real projected_area(real3 k, TableSpot spot) READS {
    real a = table_value(spot.psi, surface.tables.area_offset, surface.tables.nodes_w, spot.w);
    real linear = k.x * surface.tables.moment.x + k.y * surface.tables.moment.y;
    return max(linear + spot.scale * a, real(0.0));
}

#if HAS_ALBEDO
// R G/g with F = 1 (the paper's f0 = 1)                                    (Ashikhmin 2000, eq. 29)
real albedo_f1(AlbedoSpot spot) READS {
    return max(table_value(spot.rho, surface.tables.albedo_offset, surface.tables.nodes_v, spot.v), real(0.0));
}

// R G/g with the Fresnel factor whose value at k.n is `fresnel_at_n`: stored as its difference to
// F(k.n) times the one with F = 1, which stays smooth where all of Fresnel falls near grazing.
real fresnel_albedo(AlbedoSpot spot, real full, real fresnel_at_n, int channel) READS {
    int offset = surface.tables.residual_offset + channel * surface.tables.nodes_v * surface.tables.nodes_rho;
    return max(fresnel_at_n * full + table_value(spot.rho, offset, surface.tables.nodes_v, spot.v), real(0.0));
}
#if HAS_TINT

// albedo_f1() of each colour: where tints differ each has a table of its own, one after the other.
real3 colour_albedo_f1(AlbedoSpot spot) READS {
    if (!TINT_VARIES) return real3(albedo_f1(spot));
    int nodes = surface.tables.nodes_v;
    int green = surface.tables.albedo_offset + nodes * surface.tables.nodes_rho;
    int blue = green + nodes * surface.tables.nodes_rho;
    return real3(albedo_f1(spot), max(table_value(spot.rho, green, nodes, spot.v), real(0.0)),
                 max(table_value(spot.rho, blue, nodes, spot.v), real(0.0)));
}

// fresnel_albedo() of each colour.
real3 colour_fresnel_albedo(AlbedoSpot spot, real3 full, real3 fresnel_at_n) READS {
    return real3(fresnel_albedo(spot, full.x, fresnel_at_n.x, 0), fresnel_albedo(spot, full.y, fresnel_at_n.y, 1),
                 fresnel_albedo(spot, full.z, fresnel_at_n.z, 2));
}
#endif
#endif
