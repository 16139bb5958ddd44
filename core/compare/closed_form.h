// Models with a closed form of the same width as a design: what a design is compared with.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/bake/tables.h"

namespace nacre {

enum class ClosedFormModel { ward, ggx, beckmann, oren_nayar };  // in the order of MODEL_* of the shader

struct ClosedFormInfo {
    ClosedFormModel model;
    const char* name;      // on the command line
    const char* label;     // on the screen
    const char* citation;  // author, year, equation
};

std::span<const ClosedFormInfo> all_closed_forms();
const ClosedFormInfo& info(ClosedFormModel model);

// A model made for the surface of some tables, whose Fresnel factor and diffuse term it keeps.
struct ClosedForm {
    Shading<double>::ClosedForm form;
    std::vector<float>
        albedo;  // its tables, to stand at form.albedo_offset, behind the surface's own data; or empty
};

// The model of the same width as the tables' p: equal median slopes along the principal axes
// (facet_slopes.h). Slopes of Beckmann's facets are Gaussian with alpha^2/2 for variance, and Ward's alpha is
// theirs, so alpha = median/0.4769; GGX has alpha = sqrt(3) median. Oren and Nayar's sigma is that of
// facets as steep in the mean square, and rho the albedo of matt facets, or of a design without them its own
// mean in each colour: for that the tables must hold R, and so they must for the model's own table of albedo,
// which is made where they do.
ClosedForm matching_form(const Tables& tables, ClosedFormModel model);

// The model's BRDF of unit vectors, 1/sr; 0 where either is not above the horizon.
dvec3 closed_form_brdf(const Shading<double>& shading, const Shading<double>::ClosedForm& form, dvec3 k1,
                       dvec3 k2);

}  // namespace nacre
