#if HAS_PICTURE
// A picture at a place of the disk that touches its four sides, +x right, +y up, top row first; bilinear between texel
// centres and flat beyond the outermost. Texels off the disk hold what lies beside them on it (docs/mathematics.md, sec. 11).
real picture_at(real x, real y, int offset, int size) READS {
    real n = real(size);
    real column = clamp(real(0.5) * (real(1.0) + x) * n - real(0.5), real(0.0), n - real(1.0));
    real row = clamp(real(0.5) * (real(1.0) - y) * n - real(0.5), real(0.0), n - real(1.0));
    integer i0 = integer(column);
    integer j0 = integer(row);
    integer i1 = min(i0 + 1, size - 1);
    integer j1 = min(j0 + 1, size - 1);
    real s = column - real(i0);
    real t = row - real(j0);
    real top = fetch(offset + j0 * size + i0) * (real(1.0) - s) + fetch(offset + j0 * size + i1) * s;
    real bottom = fetch(offset + j1 * size + i0) * (real(1.0) - s) + fetch(offset + j1 * size + i1) * s;
    return top * (real(1.0) - t) + bottom * t;
}

// The upper hemisphere seen from above, the equal-area disk x = hx/sqrt(1+hz); 0 below it.
real picture_value(real3 h, int offset, int size) READS {
    real radius = sqrt(real(1.0) / (real(1.0) + max(h.z, real(0.0))));
    return select(h.z > real(0.0), picture_at(h.x * radius, h.y * radius, offset, size), real(0.0));
}
#endif
