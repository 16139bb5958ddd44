#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {

bool multibounce_panel(Multibounce& multibounce) {
    const bool chosen =
        kind_combo("Bounces", multibounce,
                   "Light that bounces from facet to facet before it leaves: rough metals are brighter "
                   "and more saturated for it.",
                   []<class T>() { return T{}; });
    return kind_fields(multibounce) || chosen;
}

}  // namespace nacre::ui
