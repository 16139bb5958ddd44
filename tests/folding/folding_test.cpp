// Folders that ignore the case of letters: two names of one file are known for one, there or not.
#include "tests/folding/folding.h"

#include <doctest/doctest.h>

#include "core/base/system/output_guard.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

constexpr long fuse = 0x65735546, ext4 = 0xef53;
// FAT, exFAT, NTFS, CIFS, SMB, HFS+
constexpr long types_without_case[] = {0x4d44,     0x2011bab0, 0x5346544e, 0x7366746e,
                                       0xff534d42, 0xfe534d42, 0x482b};

bool refused(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs = {}) {
    return !user_error_of([&] { check_outputs(outputs, inputs); }).empty();
}

}  // namespace

TEST_CASE("folding: a file in the folder tells, whatever the file system calls itself") {
    const TemporaryFolder folder;
    write_all(folder / "Probe-1", "");
    for (const long type : {0L, fuse, ext4}) {
        const FoldingFolder folding({.folder = folder.path(), .system_type = type});
        REQUIRE(fs::exists(folder / "PROBE-1"));
        CHECK(ignores_case(folder.path()));
        CHECK(refused({folder / "new.png", folder / "NEW.png"}));
        CHECK(refused({folder / "pROBE-1"}, {folder / "Probe-1"}));
        CHECK(refused({folder / "\u00c4hre.png", folder / "\u00e4hre.png"}));
        CHECK(!refused({folder / "new.png", folder / "newer.png"}));
    }
    CHECK(!ignores_case(folder.path()));
    CHECK(!refused({folder / "new.png", folder / "NEW.png"}));
}

TEST_CASE("folding: names that are told apart are so on every file system") {
    const TemporaryFolder folder;
    write_all(folder / "probe", "");
    for (const long type : types_without_case) {
        const FoldingFolder exact({.folder = folder.path(), .folds = false, .system_type = type});
        CHECK(!ignores_case(folder.path()));
        CHECK(!refused({folder / "new.png", folder / "NEW.png"}));
    }
    fs::create_hard_link(folder / "probe", folder / "PROBE");
    CHECK(!ignores_case(folder.path()));
}

TEST_CASE("folding: of a folder without a telling file its flag counts, or what file system it is") {
    const TemporaryFolder folder;
    write_all(folder / "12", "");
    CHECK(!ignores_case(folder.path()));
    const auto check_folds = [&](const Folding& folding) {
        const FoldingFolder made(folding);
        CHECK(ignores_case(folder.path()));
        CHECK(refused({folder / "new.png", folder / "NEW.png"}));
        CHECK(ignores_case(folder / "not/there/yet"));
    };
    check_folds({.folder = folder.path(), .has_flag = true});
    for (const long type : types_without_case) check_folds({.folder = folder.path(), .system_type = type});
    const FoldingFolder other({.folder = folder.path(), .folds = false, .system_type = ext4});
    CHECK(!ignores_case(folder.path()));
}
