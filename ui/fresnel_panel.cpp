#include "core/shading/surface.h"
#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {

bool fresnel_panel(Fresnel& fresnel) {
    const bool chosen =
        kind_combo("Fresnel", fresnel, "F(k\u00b7h), how much a facet mirrors at each angle.",
                   [&]<class T>() { return T::of_normal_reflectance(normal_reflectance(fresnel)); });
    return kind_fields(fresnel) || chosen;
}

}  // namespace nacre::ui
