// check --extremes: every extreme design judged.
#pragma once

#include <string>

#include "core/base/system/interrupt.h"

namespace nacre::cli {

enum class SweepFormat { text, json, markdown };

// What is wrong with the name of a group; empty when there is such a group.
std::string known_group(const std::string& group);

// The same of a text that names of cases must hold; empty when one does.
std::string known_case(const std::string& text);

// Which cases: of one group, and whose name holds a text; empty ones choose all.
struct SweepChoice {
    std::string group, text;
};

// The exit code: 1 when a case does not hold.
int sweep_extremes(const SweepChoice& choice, SweepFormat format, const Interrupt& interrupt);

}  // namespace nacre::cli
