#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {

bool coat_panel(Coat& coat) {
    const bool chosen = kind_combo("Coat", coat,
                                   "A layer over the facets, with a highlight of its own: lacquer, varnish, "
                                   "water.",
                                   []<class T>() { return T{}; });
    return kind_fields(coat) || chosen;
}

}  // namespace nacre::ui
