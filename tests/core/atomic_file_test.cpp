#include "core/exchange/atomic_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/core/file_size_limit.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using nacre::test::FileSizeLimit;
using nacre::test::read_all;
using nacre::test::TemporaryFolder;
using nacre::test::user_error_of;
using nacre::test::write_all;

namespace fs = std::filesystem;

namespace {

std::string error_of_writing(const fs::path& file, std::string_view bytes = "new") {
    return user_error_of([&] { write_file_atomically(file, bytes); });
}

}  // namespace

TEST_SUITE("atomic file") {
    TEST_CASE("atomic file: a new file and a replaced one hold the bytes, and nothing else is left") {
        const TemporaryFolder folder;
        const fs::path file = folder / "a.nacre";
        write_file_atomically(file, std::string_view("first\0second", 12));
        CHECK(read_all(file) == std::string("first\0second", 12));
        write_file_atomically(file, "");
        CHECK(read_all(file).empty());
        CHECK(folder.size() == 1);
    }

    TEST_CASE("atomic file: a replaced file keeps its permissions, a link keeps being a link") {
        const TemporaryFolder folder;
        write_all(folder / "target", "old");
        fs::permissions(folder / "target", fs::perms::owner_read | fs::perms::owner_write);
        fs::create_symlink("target", folder / "link");
        write_file_atomically(folder / "link", "new");
        CHECK(fs::is_symlink(folder / "link"));
        CHECK(read_all(folder / "target") == "new");
        CHECK(fs::status(folder / "target").permissions() ==
              (fs::perms::owner_read | fs::perms::owner_write));
    }

    TEST_CASE("atomic file: a symbolic link to nothing gets its target, wherever that is") {
        const TemporaryFolder folder;
        fs::create_directory(folder / "sub");
        fs::create_symlink("sub/next", folder / "link");
        fs::create_symlink("../target", folder / "sub/next");
        write_file_atomically(folder / "link", "new");
        CHECK(fs::is_symlink(folder / "link"));
        CHECK(fs::is_symlink(folder / "sub/next"));
        CHECK(read_all(folder / "target") == "new");
        fs::create_symlink("missing/target", folder / "lost");
        CHECK(error_of_writing(folder / "lost").find("(No such file or directory)") != std::string::npos);
        fs::create_symlink("round", folder / "round");
        CHECK(error_of_writing(folder / "round").find("(Too many levels of symbolic links)") !=
              std::string::npos);
        CHECK(folder.size() == 5);
    }

    TEST_CASE("atomic file: the system's reason is told and the old file stays") {
        const TemporaryFolder folder;
        write_all(folder / "file", "old");
        fs::create_directory(folder / "directory");
        CHECK(error_of_writing(folder / "missing/a.nacre").find("(No such file or directory)") !=
              std::string::npos);
        CHECK(error_of_writing(folder / "file/a.nacre").find("(Not a directory)") != std::string::npos);
        CHECK(error_of_writing(folder / "directory").find("directory") != std::string::npos);
        CHECK(error_of_writing(folder / "directory/").find("directory") != std::string::npos);
        CHECK(error_of_writing(folder / (std::string(300, 'n') + ".nacre")).find("File name too long") !=
              std::string::npos);
        CHECK(read_all(folder / "file") == "old");
        CHECK(folder.size() == 2);
    }

    TEST_CASE("atomic file: devices and pipes are refused and stay") {
        const TemporaryFolder folder;
        REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
        CHECK(error_of_writing(folder / "pipe").find("not a regular file") != std::string::npos);
        CHECK(fs::is_fifo(folder / "pipe"));
        CHECK(error_of_writing("/dev/full").find("not a regular file") != std::string::npos);
        CHECK(fs::is_character_file("/dev/full"));
    }

    TEST_CASE("atomic file: an unwritable folder or file" * doctest::skip(geteuid() == 0)) {
        const TemporaryFolder folder;
        write_all(folder / "file", "old");
        fs::permissions(folder / "file", fs::perms::owner_read);
        CHECK(error_of_writing(folder / "file").find("(Permission denied)") != std::string::npos);
        fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
        CHECK(error_of_writing(folder / "new").find("(Permission denied)") != std::string::npos);
        fs::permissions(folder.path(), fs::perms::owner_all);
        CHECK(read_all(folder / "file") == "old");
    }

    TEST_CASE("atomic file: a full disk leaves the old file and no temporary one") {
        const TemporaryFolder folder;
        const fs::path file = folder / "a.nacre";
        write_all(file, "old");
        // The smaller text shows its failure only on close, the larger one before.
        for (const std::size_t size : {2000u, 200'000u}) {
            std::string line;
            {
                const FileSizeLimit limit(1000);
                line = error_of_writing(file, std::string(size, 'x'));
            }
            CHECK(line.find("(File too large)") != std::string::npos);
            CHECK(read_all(file) == "old");
            CHECK(folder.size() == 1);
        }
    }

    TEST_CASE("atomic file: a callback fills a file with the wanted extension") {
        const TemporaryFolder folder;
        const fs::path file = folder / "picture.exr";
        write_file_atomically(file, [&](const fs::path& temporary) {
            CHECK(temporary.extension() == ".exr");
            CHECK(temporary.parent_path() == folder.path());
            CHECK_FALSE(fs::exists(file));
            write_all(temporary, "picture");
        });
        CHECK(read_all(file) == "picture");
        CHECK(folder.size() == 1);
    }

    TEST_CASE("atomic file: a callback that throws, or loses the file, leaves nothing") {
        const TemporaryFolder folder;
        const fs::path file = folder / "picture.exr";
        const auto throws = [](const fs::path& temporary) {
            write_all(temporary, "half");
            throw std::runtime_error("stopped");
        };
        CHECK_THROWS_WITH_AS(write_file_atomically(file, throws), "stopped", std::runtime_error);
        CHECK(folder.size() == 0);
        const std::string line = user_error_of(
            [&] { write_file_atomically(file, [](const fs::path& temporary) { fs::remove(temporary); }); });
        CHECK(line.find("No such file or directory") != std::string::npos);
        CHECK(folder.size() == 0);
    }
}
