// Makes a folder ignore the case of ASCII letters for this process, whatever file system it lies on: the
// calls of libc by which a program could tell go through tests/folding/folding.cpp.
#pragma once

#include <string>

namespace nacre::test {

struct Folding {
    std::string folder;     // absolute; the folder itself, not those in it
    bool folds = true;      // names are found in any case
    bool has_flag = false;  // FS_CASEFOLD_FL, as ext4 and f2fs have it
    long system_type = 0;   // what statfs(2) tells; 0: the truth
};

class FoldingFolder {
  public:
    explicit FoldingFolder(const Folding& folding);
    ~FoldingFolder();
    FoldingFolder(const FoldingFolder&) = delete;
    FoldingFolder& operator=(const FoldingFolder&) = delete;
};

}  // namespace nacre::test
