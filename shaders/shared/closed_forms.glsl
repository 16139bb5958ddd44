// Models of reflection with a closed form, to be seen beside p's own BRDF: each by its published formula, 1/sr, with the
// Fresnel factor of the design. Unit vectors above the horizon; sums and products do not change when k1 and k2
// change places.

CONSTANT int MODEL_WARD = 0;
CONSTANT int MODEL_GGX = 1;
CONSTANT int MODEL_BECKMANN = 2;
CONSTANT int MODEL_OREN_NAYAR = 3;

struct ClosedForm {
    int model;               // MODEL_*
    scalar2 axis;            // cos and sin of the azimuth that alpha_x belongs to
    scalar2 width;           // alpha_x, alpha_y
    scalar2 inverse_width;   // 1/alpha_x, 1/alpha_y
    scalar scale;            // 1/(pi alpha_x alpha_y)
    scalar sigma2;           // Oren-Nayar: square of the standard deviation of the facets' angles, radians
    scalar3 rho;             // Oren-Nayar: albedo of the facets
    int albedo_offset;       // in the surface's data: three tables of MODEL_AZIMUTHS rows of MODEL_NODES, or -1
};

CONSTANT int MODEL_NODES = 33;    // along w = sin/(cos + sin)
CONSTANT int MODEL_AZIMUTHS = 5;  // over a quarter turn

// k in the frame of the model's own axes.
PURE real3 in_model_axes(ClosedForm form, real3 k) {
    return real3(form.axis.x * k.x + form.axis.y * k.y, form.axis.x * k.y - form.axis.y * k.x, k.z);
}

#if HAS_GAUSSIAN
// exp(-tan^2(delta) (cos^2(phi)/ax^2 + sin^2(phi)/ay^2))/(4 pi ax ay sqrt(c1 c2))          (Ward 1992, eq. 5a)
// delta and phi of the half vector, of which any length will do (Walter 2005, eq. 4).
PURE real ward(ClosedForm form, real3 k1, real3 k2) {
    real lobe = real(0.25) * form.scale * gaussian_density(k1 + k2, form.inverse_width);
    return safe_divide(lobe, sqrt(k1.z * k2.z));
}
#endif

#if HAS_GGX
// D(h)/(2 (c2 r1 + c1 r2)), r = |(ax kx, ay ky, kz)|: GGX (Walter 2007, eq. 33) with the height-correlated masking of
// Smith's model                                                                (Heitz 2014, eq. 85, 86 and 99)
PURE real ggx_reach(ClosedForm form, real3 k) {
    real x = form.width.x * k.x;
    real y = form.width.y * k.y;
    return sqrt(x * x + y * y + k.z * k.z);
}

PURE real ggx(ClosedForm form, real3 k1, real3 k2, real3 h) {
    real lobe = real(0.5) * form.scale * ggx_density(h, form.inverse_width);
    return safe_divide(lobe, k2.z * ggx_reach(form, k1) + k1.z * ggx_reach(form, k2));
}
#endif

#if HAS_BECKMANN
// D(h) G/(4 c1 c2) with Beckmann's facets and the V-grooves of Torrance and Sparrow,
// G = min(1, 2 hz c1/(k.h), 2 hz c2/(k.h))                    (Cook and Torrance 1982, eq. 14 and sec. 4)
// Their constant 1/pi is 1/4 where D is normalised (Walter 2007, eq. 20).
PURE real cook_torrance(ClosedForm form, real3 k1, real3 k2, real3 h, real cosine) {
    real lobe = real(0.25) * form.scale * beckmann_density(h, form.inverse_width);
    real grooves = min(real(2.0) * h.z * min(k1.z, k2.z) / cosine, real(1.0));
    return safe_divide(lobe * grooves, k1.z * k2.z);
}
#endif

// Facets of Lambert's kind in V-grooves whose angles are spread as a Gaussian of sigma, with masking, shadowing and one
// interreflection                                                      (Oren and Nayar 1994, eq. 27 to 29)
// Near grazing and away from the light the published fit falls below 0; here it stops there.
PURE real3 oren_nayar(ClosedForm form, real3 k1, real3 k2) {
    real sine1 = sqrt(k1.x * k1.x + k1.y * k1.y);
    real sine2 = sqrt(k2.x * k2.x + k2.y * k2.y);
    real theta1 = atan(sine1, k1.z);
    real theta2 = atan(sine2, k2.z);
    real alpha = max(theta1, theta2);
    real beta = (real(2.0) / TABLE_PI) * min(theta1, theta2);  // in right angles
    real across = sine1 * sine2;
    condition upright = across <= real(0.0);
    real turn = (k1.x * k2.x + k1.y * k2.y) / select(upright, real(1.0), across);
    turn = min(max(turn, real(-1.0)), real(1.0));  // cos(phi2 - phi1)
    scalar share = form.sigma2 / (form.sigma2 + scalar(0.09));
    real lean = max(sine1, sine2) - select(turn >= real(0.0), real(0.0), beta * beta * beta);
    real tan_beta = safe_divide(min(sine1, sine2), max(k1.z, k2.z));
    // tan((theta1 + theta2)/2) = sin/(1 + cos) of the sum.
    real tan_middle = safe_divide(sine1 * k2.z + sine2 * k1.z,
                                       max(real(1.0) + (k1.z * k2.z - across), real(0.0)));
    real angles = (real(2.0) / TABLE_PI) * alpha * beta;  // 4 alpha beta/pi^2
    real once = real(1.0) - real(0.5) * (form.sigma2 / (form.sigma2 + scalar(0.33)));
    once += turn * (real(0.45) * share * lean * tan_beta);
    once += (real(1.0) - abs(turn)) * (real(0.125) * share * angles * angles * tan_middle);
    real twice = real(0.17) * (form.sigma2 / (form.sigma2 + scalar(0.13))) * (real(1.0) - turn * beta * beta);
    real3 rho = real3(form.rho);
    return rho * (max(once, real(0.0)) / TABLE_PI) + rho * rho * (max(twice, real(0.0)) / TABLE_PI);
}

// The model in the place of p's own specular term; Oren and Nayar's is the whole of a surface.
real3 closed_form_specular(ClosedForm form, real3 k1, real3 k2) READS {
    real3 a = in_model_axes(form, k1);
    real3 b = in_model_axes(form, k2);
    HalfVector between = half_vector(a, b);
    real rho = real(0.0);
#if HAS_GAUSSIAN
    if (form.model == MODEL_WARD) rho = ward(form, a, b);
#endif
#if HAS_GGX
    if (form.model == MODEL_GGX) rho = ggx(form, a, b, between.h);
#endif
#if HAS_BECKMANN
    if (form.model == MODEL_BECKMANN) rho = cook_torrance(form, a, b, between.h, between.cosine);
#endif
    return fresnel(between.cosine) * min(rho, real(LARGEST));
}

// Beside a specular model the design keeps its own diffuse term.
real3 closed_form_diffuse(ClosedForm form, Direction a, Direction b) READS {
    if (form.model == MODEL_OREN_NAYAR) return oren_nayar(form, a.k, b.k);
    return diffuse(a, b);
}

#if HAS_ALBEDO
// What of a constant environment of radiance 1 the model by itself sends toward k, from its table.
real3 closed_form_albedo(ClosedForm form, real3 k) READS {
    real3 own = in_model_axes(form, k);
    real sine = sqrt(own.x * own.x + own.y * own.y);
    real place = quarter_turns(abs(own.x), abs(own.y)) * real(MODEL_AZIMUTHS - 1);
    TableRows rows;
    rows.first = min(integer(place), MODEL_AZIMUTHS - 1);
    rows.second = min(rows.first + 1, MODEL_AZIMUTHS - 1);
    rows.fraction = place - real(rows.first);
    real w = min(sine / (own.z + sine), real(1.0));
    int size = MODEL_NODES * MODEL_AZIMUTHS;
    return real3(table_value(rows, form.albedo_offset, MODEL_NODES, w),
                 table_value(rows, form.albedo_offset + size, MODEL_NODES, w),
                 table_value(rows, form.albedo_offset + 2 * size, MODEL_NODES, w));
}
#endif
