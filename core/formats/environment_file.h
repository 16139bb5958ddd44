// Environments by name or from a file.
#pragma once

#include <memory>
#include <string>

#include "core/light/environment.h"

namespace nacre {

// A procedural environment's name, else the path of a lat-long picture. A UserError of the
// path where it is neither.
std::shared_ptr<const Environment> load_environment(const std::string& name_or_file);

}  // namespace nacre
