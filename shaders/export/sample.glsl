// Draws directions toward light for renderers that sample a design, and says how densely: for exports. In the data from
// DRAW_OFFSET stands a table of half vectors: DRAW_ROWS + 1 rising shares from 0 to 1, as many bounds of t = 1 - h.z from 0 to
// 1, and of each row DRAW_COLUMNS + 1 bounds of the azimuth from -pi to pi. The rows of bounds are DRAW_STRIDE apart, 0 where all
// rows share one. A cell is drawn as often as its row's share over DRAW_COLUMNS, and within it all solid angle alike.
// Every half vector above the horizon can be drawn, so the density is above 0 for every pair of directions above it.

// Which of `cells` between rising bounds holds a value; a power of two.
integer draw_cell(int offset, int cells, real value) READS {
    integer low = integer(0);
    for (int step = cells / 2; step > 0; step /= 2)
        low += select(value < fetch(offset + low + step), integer(0), integer(step));
    return low;
}

// A half vector from two numbers in [0, 1).
real3 drawn_half(real u, real v) READS {
    integer row = draw_cell(DRAW_OFFSET, DRAW_ROWS, u);
    integer share = row + DRAW_OFFSET;
    integer bound = share + (DRAW_ROWS + 1);
    real part = (u - fetch(share)) / (fetch(share + 1) - fetch(share));
    real t = fetch(bound) + part * (fetch(bound + 1) - fetch(bound));
    real place = v * real(DRAW_COLUMNS);
    integer column = min(integer(place), DRAW_COLUMNS - 1);
    integer at = row * DRAW_STRIDE + column + (DRAW_OFFSET + 2 * (DRAW_ROWS + 1));
    real azimuth = fetch(at) + (place - real(column)) * (fetch(at + 1) - fetch(at));
    real sine = sqrt(max(t * (real(2.0) - t), real(0.0)));
    return real3(sine * cos(azimuth), sine * sin(azimuth), real(1.0) - t);
}

// How densely it is drawn, 1/sr; h.z >= 0.
real half_drawn(real3 h) READS {
    real t = (h.x * h.x + h.y * h.y) / (real(1.0) + h.z);
    integer row = draw_cell(DRAW_OFFSET + DRAW_ROWS + 1, DRAW_ROWS, t);
    integer share = row + DRAW_OFFSET;
    integer bound = share + (DRAW_ROWS + 1);
    condition upright = h.x == real(0.0) && h.y == real(0.0);
    real azimuth = atan(h.y, select(upright, real(1.0), h.x));
    int first = DRAW_OFFSET + 2 * (DRAW_ROWS + 1);
    integer at = row * DRAW_STRIDE + first;
    at = at + draw_cell(at, DRAW_COLUMNS, azimuth);
    real area = (fetch(bound + 1) - fetch(bound)) * (fetch(at + 1) - fetch(at));
    return (fetch(share + 1) - fetch(share)) / (area * real(DRAW_COLUMNS));
}

// k in a mirror of normal h; below the horizon where k sees its back.
PURE real3 mirrored(real3 k, real3 h) {
    return h * (real(2.0) * dot(k, h)) - k;
}

// How densely mirrors from that table send one direction into the other, 1/sr.
real mirrored_drawn(real3 k1, real3 k2) READS {
    HalfVector between = half_vector(k1, k2);
    return select(between.exists, safe_divide(real(0.25) * half_drawn(between.h), between.cosine), real(0.0));
}

// The same of all ways in which the facets send light, beneath a coat if there is one.
real facets_drawn(real3 k1, real3 k2) READS {
    real plain = mirrored_drawn(k1, k2);
#if HAS_RETRO
    real back = real(0.5) * (mirrored_drawn(turned(k1), k2) + mirrored_drawn(k1, turned(k2)));
    plain = plain * real(scalar(1.0) - surface.retro) + back * real(surface.retro);
#endif
    return plain;
}
#if HAS_COAT

// How often the coat's own facets are drawn: as much of the light as they mirror.
real coat_share(real3 k) READS {
    return clamp(coat_albedo(sqrt(k.z)), real(0.1), real(0.9));
}

// One of them; they are Beckmann's, drawn as densely as p(h) h.z         (Walter 2007, eq. 28)
real3 coat_half(real u, real v) READS {
    real tangent2 = real(-surface.coat_width * surface.coat_width) * log(real(1.0) - u);
    real cosine = real(1.0) / sqrt(real(1.0) + tangent2);
    real sine = cosine * sqrt(tangent2);
    real azimuth = real(2.0) * TABLE_PI * v;
    return real3(sine * cos(azimuth), sine * sin(azimuth), cosine);
}
#endif

// A direction k1 for light that leaves toward k, from three numbers in [0, 1); k1.z <= 0 where the sample is lost.
real3 drawn_direction(real3 k, real3 u) READS {
    if (none(k.z > real(0.0))) return real3(0.0);
    real3 from = k;
    real choice = u.z;
#if HAS_COAT
    real part = coat_share(k);
    if (choice < part) return mirrored(k, coat_half(u.x, u.y));
    choice = (choice - part) / (real(1.0) - part);
    from = refracted(k);
#endif
    if (choice < real(COSINE_SHARE)) {
        real azimuth = real(2.0) * TABLE_PI * u.y;
        real sine = sqrt(u.x);
        return real3(sine * cos(azimuth), sine * sin(azimuth), sqrt(real(1.0) - u.x));
    }
    real3 h = drawn_half(u.x, u.y);
#if HAS_RETRO
    choice = (choice - real(COSINE_SHARE)) / real(scalar(1.0) - COSINE_SHARE);
    condition back = choice < real(surface.retro);
    condition before = choice < real(scalar(0.5) * surface.retro);
    from = select(before, turned(from), from);
#endif
    real3 other = mirrored(from, h);
#if HAS_RETRO
    other = select(back && none(before), turned(other), other);
#endif
#if HAS_COAT
    other = select(other.z > real(0.0), emerging(other), real3(0.0));
#endif
    return other;
}

// How densely it draws k1 for light that leaves toward k2, 1/sr; 0 where either is not above the horizon.
real drawn_density(real3 k1, real3 k2) READS {
    condition above = k1.z > real(0.0) && k2.z > real(0.0);
    if (none(above)) return real(0.0);
    real even = COSINE_SHARE * (k1.z / TABLE_PI);
#if HAS_COAT
    real3 inside = refracted(k1);
    HalfVector between = half_vector(k1, k2);
    real coat = safe_divide(real(0.25) * coat_density(between.h.z) * between.h.z, between.cosine);
    real part = coat_share(k2);
    scalar square = surface.coat_ior * surface.coat_ior;
    real facets = facets_drawn(inside, refracted(k2)) * (k1.z / (inside.z * square));
    return part * coat + (real(1.0) - part) * (even + (scalar(1.0) - COSINE_SHARE) * facets);
#endif
#if IS_BARE
    return even + (scalar(1.0) - COSINE_SHARE) * facets_drawn(k1, k2);
#endif
}
