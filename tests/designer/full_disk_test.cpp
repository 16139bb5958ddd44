// Where nothing can be written it is told, and the work is still there.
#include <doctest/doctest.h>
#include <sys/mount.h>
#include <unistd.h>

#include "tests/core/file_size_limit.h"
#include "tests/designer/kept_work.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

// Saving there must fail with the system's reason, and leave the file, the work and the question before it is
// lost as they were.
void check_refused_save(const fs::path& file, const std::string& reason) {
    Rig r;
    r.document() = painted_document();
    r.document().file = file;
    r.document().held = held_now(std::vector<fs::path>{file});
    const Design before = r.document().design;
    const std::string on_disk = read_all(file);
    r.play("key Ctrl+S\nframes 5");
    CHECK(r.designer().files.talking());
    CHECK_MESSAGE(r.designer().files.problem().find(reason) != std::string::npos,
                  r.designer().files.problem());
    r.play("key Enter\nframes 5");
    CHECK(r.document().design == before);
    CHECK(r.document().unsaved());
    CHECK(read_all(file) == on_disk);
}

}  // namespace

TEST_CASE("full disk: a file that may not grow is told, and the work is still there") {
    const TemporaryFolder folder;
    write_all(folder / "mine.nacre", "old");
    const FileSizeLimit limit(100'000);
    check_refused_save(folder / "mine.nacre", "File too large");
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.document() = painted_document();
    r.play("frames 1");
    r.designer().autosave.wait();
    r.play("frames 1");
    CHECK(r.designer().autosave.problem().find("File too large") != std::string::npos);
}

TEST_CASE("full disk: a small tmpfs") {
    const TemporaryFolder folder;
    if (::mount("nacre", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0) {
        MESSAGE("skipped: no tmpfs can be mounted here");
        return;
    }
    write_all(folder / "mine.nacre", "old");
    check_refused_save(folder / "mine.nacre", "No space left on device");
    ::umount(folder.path().c_str());
}

TEST_CASE("read-only folder: told, and the work is still there") {
    const TemporaryFolder folder;
    write_all(folder / "mine.nacre", "old");
    // What is forbidden to others is allowed to root: it becomes nobody for a while.
    const bool root = geteuid() == 0;
    fs::permissions(folder.path(), fs::perms(0555));
    if (root) REQUIRE(seteuid(65534) == 0);
    check_refused_save(folder / "mine.nacre", "Permission denied");
    if (root) REQUIRE(seteuid(0) == 0);
    fs::permissions(folder.path(), fs::perms::owner_all);
}
