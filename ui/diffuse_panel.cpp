#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {

bool diffuse_panel(Diffuse& diffuse) {
    const glm::dvec3 albedo =
        std::visit([](const auto& model) { return model.own_albedo(); }, diffuse).value_or(glm::dvec3(0.5));
    const bool chosen = kind_combo("Diffuse", diffuse, "Light that comes back without a mirror reflection.",
                                   [&]<class T>() { return T::of_albedo(albedo); });
    return kind_fields(diffuse) || chosen;
}

}  // namespace nacre::ui
