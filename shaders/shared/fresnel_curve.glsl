// F as a table of a.y nodes, red, green and blue of each: node i of n at the cosine (i/(n - 1))^2, straight lines in the
// root of the cosine between nodes. Films and metals turn fastest near grazing, where the root puts more nodes. A facet on
// edge may have a cosine just below 0.
real3 table_fresnel(scalar3 a, real cosine) READS {
    int nodes = int(a.y);
    real place = sqrt(max(cosine, real(0.0))) * real(nodes - 1);
    integer node = min(integer(place), nodes - 2);
    real s = place - real(node);
    integer at = node * 3;
    return real3(fetch_curve(at) * (real(1.0) - s) + fetch_curve(at + 3) * s,
                 fetch_curve(at + 1) * (real(1.0) - s) + fetch_curve(at + 4) * s,
                 fetch_curve(at + 2) * (real(1.0) - s) + fetch_curve(at + 5) * s);
}
