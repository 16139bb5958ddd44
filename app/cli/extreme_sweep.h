// check --extremes: every extreme design judged.
#pragma once

#include <string>

#include "core/base/system/interrupt.h"

namespace nacre::cli {

enum class SweepFormat { text, json, markdown };

// What is wrong with the name of a group; empty when there is such a group.
std::string known_group(const std::string& group);

// The cases of one group, or all with an empty name. The exit code: 1 when a case does not hold.
int sweep_extremes(const std::string& group, SweepFormat format, const Interrupt& interrupt);

}  // namespace nacre::cli
