#pragma once

#include <vector>

#include "core/design/design.h"

namespace nacre::test {

// A design that its file can hold, drawn inside a RapidCheck property: every lobe and model, values
// with all their digits, names of any characters. Its pictures are rasters of its own or `files`.
Design random_design(const std::vector<Picture>& files);

}  // namespace nacre::test
