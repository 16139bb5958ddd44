#include "app/designer/take_back.h"

#include "app/designer/designer.h"

namespace nacre {

AtRest at_rest(const Designer& designer) {
    return {.scene = designer.scene,
            .camera = designer.canvas.state.camera,
            .layout = designer.settings.values.layout,
            .plots = designer.plots.state,
            .divider = designer.preview.look.divider,
            .layer = designer.layers.chosen};
}

void take_back(Designer& designer) {
    designer.document.design = designer.document.history.current();
    const AtRest& rest = designer.rest;
    designer.scene = rest.scene;
    designer.canvas.state.camera = rest.camera;
    designer.settings.values.layout = rest.layout;
    designer.plots.state = rest.plots;
    designer.preview.look.divider = rest.divider;
    designer.layers.chosen = rest.layer;
}

}  // namespace nacre
