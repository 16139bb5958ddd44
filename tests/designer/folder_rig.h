// A designer beside a folder of a test's own, whose files are dropped on it.
#pragma once

#include <string>

#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

namespace nacre::test {

struct FolderRig : Rig {
    TemporaryFolder folder;
    FolderRig() : Rig(2) {}
    std::string drop(const char* name) { return "drop \"" + (folder / name).string() + "\"\nframes 3\n"; }
    // Of the cards of a picture that was dropped, by its name.
    static std::string card(const char* use) { return "click \"As " + std::string(use) + "\"\nframes 2\n"; }
    // Uses it as the chosen card says.
    static std::string accept() { return "click \"Import\"\nwait\nframes 3\n"; }
    static std::string import(const char* use) { return card(use) + accept(); }
};

}  // namespace nacre::test
