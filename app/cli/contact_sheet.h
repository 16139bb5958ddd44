// Many pictures on one, each with its name below it.
#pragma once

#include <string>
#include <vector>

#include "app/preview/render.h"

namespace nacre::cli {

struct SheetPicture {
    std::string name;
    RenderedImage image;  // all of one size
};

RenderedImage contact_sheet(const std::vector<SheetPicture>& pictures);

}  // namespace nacre::cli
