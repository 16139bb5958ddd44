// a(k1) a(k2) [qs(t1 + t2) + qd(t1 - t2)], t = (kx, ky): light that is mirrored twice changes t by what it meets. One bounce
// leaves t1 + t2 along h; the second bounce of a groove keeps t1 - t2.

// Four neighbours of a table over a disk of radius 2, and a place between them.
struct MomentumSpot {
    integer first;
    integer second;  // in the next row
    real x;
    real y;
};

// Of the difference where `difference`, which is even. Nodes lie evenly from 0 to 2, or from -2 to 2 where p lacks the mirror
// plane; of an isotropic p along the length of t alone.
MomentumSpot momentum_spot(real2 t, bool difference) READS {
    int symmetry = surface.tables.symmetry;
    int nodes = surface.tables.momentum_nodes;
    bool whole_x = !difference && (symmetry == SYMMETRY_HALF || symmetry == SYMMETRY_NONE);
    bool whole_y = symmetry == SYMMETRY_NONE;
    real x = surface.tables.axis.x * t.x + surface.tables.axis.y * t.y;
    real y = surface.tables.axis.x * t.y - surface.tables.axis.y * t.x;
    if (symmetry == SYMMETRY_ISOTROPIC) {
        x = length(t);
        y = real(0.0);
    }
    if (symmetry == SYMMETRY_NONE && difference) {
        condition turned = x < real(0.0) || (x == real(0.0) && y < real(0.0));
        x = select(turned, -x, x);
        y = select(turned, -y, y);
    }
    if (!whole_x) x = abs(x);
    if (!whole_y) y = abs(y);
    int nodes_x = whole_x ? 2 * nodes - 1 : nodes;
    int nodes_y = whole_y ? 2 * nodes - 1 : nodes;
    real scale = real(0.5) * real(nodes - 1);
    x = (whole_x ? x + real(2.0) : x) * scale;
    y = (whole_y ? y + real(2.0) : y) * scale;
    integer column = min(integer(x), nodes_x - 2);
    integer row = min(integer(y), nodes_y - 2);
    MomentumSpot spot;
    spot.x = x - real(column);
    spot.y = y - real(row);
    spot.first = row * nodes_x + column;
    spot.second = spot.first + nodes_x;
    if (symmetry == SYMMETRY_ISOTROPIC) spot.second = spot.first;
    return spot;
}

real momentum_value(int offset, MomentumSpot spot) READS {
    integer a = offset + spot.first;
    integer b = offset + spot.second;
    real first = fetch(a) * (real(1.0) - spot.x) + fetch(a + 1) * spot.x;
    real second = fetch(b) * (real(1.0) - spot.x) + fetch(b + 1) * spot.x;
    return first * (real(1.0) - spot.y) + second * spot.y;
}

// a stands over the stereographic disk, which is wide at grazing.
real momentum_amplitude(real3 k) READS {
    real scale = real(2.0) / (real(1.0) + k.z);
    return momentum_value(surface.tables.amplitude_offset, momentum_spot(real2(scale * k.x, scale * k.y), false));
}

// What M brings toward k of light from everywhere, over a(k): it is smooth, however rough a is.
real momentum_row(AlbedoSpot spot) READS {
    return bounce_table(spot, surface.tables.row_offset, 0);
}

real3 momentum_spread(AlbedoSpot spot, real row) READS {
    return bounce_row(spot, row);
}

real momentum_kernel(Direction a, Direction b) READS {
    real2 sum = real2(a.k.x + b.k.x, a.k.y + b.k.y);
    real2 difference = real2(a.k.x - b.k.x, a.k.y - b.k.y);
    return (a.amplitude * b.amplitude) *
           (momentum_value(surface.tables.sum_offset, momentum_spot(sum, false)) +
            momentum_value(surface.tables.difference_offset, momentum_spot(difference, true)));
}
