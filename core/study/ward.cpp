#include "core/study/ward.h"

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

}  // namespace

Shading<double>::ClosedForm ward_form(dvec2 alpha) {
    Shading<double>::ClosedForm form{};
    form.model = Shading<double>::MODEL_WARD;
    form.axis = {1, 0};
    form.width = alpha;
    form.inverse_width = 1.0 / alpha;
    form.scale = 1 / (pi * alpha.x * alpha.y);
    form.albedo_offset = -1;
    return form;
}

double ward_brdf(WardForm which, const Shading<double>::ClosedForm& form, dvec3 k1, dvec3 k2) {
    const double published = Shading<double>::ward(form, k1, k2), root = std::sqrt(k1.z * k2.z);
    switch (which) {
        case WardForm::published:
            return published;
        case WardForm::corrected:
            return published / root;
        case WardForm::bounded: {
            const dvec3 sum = k1 + k2;
            return published * root * 4 * glm::dot(sum, sum) / std::pow(sum.z, 4);
        }
    }
    return 0;
}

// Facets of slopes alpha_x r cos(phi), alpha_y r sin(phi) that mirror k, drawn evenly in exp(-r^2) and phi;
// dk2 = 4 (k.h) dh and dh = hz^3 dslope.
double ward_albedo(WardForm which, const Shading<double>::ClosedForm& form, dvec3 k, int points) {
    double sum = 0;
    for (int i = 0; i < points; ++i) {
        const double left = 1 - (i + 0.5) / points;  // exp(-r^2)
        const double r = std::sqrt(-std::log(left));
        for (int j = 0; j < points; ++j) {
            const double phi = 2 * pi * (j + 0.5) / points;
            const dvec3 h =
                glm::normalize(dvec3{r * form.width.x * std::cos(phi), r * form.width.y * std::sin(phi), 1});
            const double cosine = glm::dot(k, h);
            const dvec3 k2 = 2 * cosine * h - k;
            if (cosine <= 0 || k2.z <= 0) continue;
            sum += ward_brdf(which, form, k, k2) * k2.z * 4 * cosine * (h.z * h.z * h.z) / left;
        }
    }
    return sum * pi * form.width.x * form.width.y / (static_cast<double>(points) * points);
}

}  // namespace nacre
