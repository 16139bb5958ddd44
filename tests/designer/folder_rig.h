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
};

}  // namespace nacre::test
