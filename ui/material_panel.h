// What the facets are made of: reflection, diffuse part, masking.
#pragma once

#include "core/design/design.h"

namespace nacre::ui {

// Each returns whether its value changed.
bool fresnel_panel(Fresnel& fresnel);
bool diffuse_panel(Diffuse& diffuse);
bool multibounce_panel(Multibounce& multibounce);
bool shadowing_panel(Shadowing& shadowing, double& mean_cosine_scale);
bool retro_panel(Retro& retro);
bool coat_panel(Coat& coat);

}  // namespace nacre::ui
