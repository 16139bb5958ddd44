// Painting as by hand, and what has come of it.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "core/model/polar_angles.h"
#include "core/paint/layer_paint.h"
#include "core/paint/raster_texels.h"
#include "tests/designer/rig.h"
#include "ui/keys.h"

namespace nacre::test {

struct CanvasRig : Rig {
    using Rig::Rig;

    const Raster& raster(std::size_t layer, LayerPart part = LayerPart::lobe) {
        const Picture* const picture = part_picture(layers().at(layer), part);
        REQUIRE(picture != nullptr);
        return *picture->raster;
    }
    double value(std::size_t layer, dvec3 h, LayerPart part = LayerPart::lobe) {
        const Raster& values = raster(layer, part);
        return raster_value(values.values, values.width, disk_point(h));
    }
    double value(std::size_t layer, double theta, double phi, LayerPart part = LayerPart::lobe) {
        return value(layer, polar_direction(theta, phi), part);
    }

    void play_with(bool ctrl, bool shift, bool alt, const std::string& events) {
        ui::tell_modifiers(ImGui::GetIO(), ctrl, shift, alt);
        play(events);
        ui::tell_modifiers(ImGui::GetIO(), false, false, false);
        play("frames 1");
    }

    // How much of a normal is selected; everything where nothing is.
    double selected(double theta, double phi) {
        return canvas().selection ? (*canvas().selection)(polar_direction(theta, phi)) : 1;
    }
};

}  // namespace nacre::test
