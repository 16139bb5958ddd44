#pragma once

namespace nacre {

// An entry of a list in the order of an enumeration.
struct Choice {
    const char* name;   // in files
    const char* label;  // in the interface
    const char* about;
};

}  // namespace nacre
