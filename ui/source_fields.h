// The settings of what is made of a picture, as rows of the current window.
#pragma once

#include "core/model/picture_source.h"
#include "core/paint/normal_map.h"

namespace nacre::ui {

// What is known of the picture; a picture that has not been read is of no help.
struct SourceHelp {
    const NormalMapLook* look = nullptr;
};

// Those of the way in which it is used. Each returns whether one changed.
bool source_fields(PictureSource& source, const SourceHelp& help = {});

// Rotation and flip alone.
bool pose_fields(PictureSource& source);

}  // namespace nacre::ui
