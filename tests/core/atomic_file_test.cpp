#include "core/base/system/atomic_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cstdint>

#include "core/image/image_file.h"
#include "tests/core/file_size_limit.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

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

    TEST_CASE("atomic file: group and mode stay, what lets a program run as somebody else does not") {
        const TemporaryFolder folder;
        const fs::path file = folder / "file";
        const auto group_of = [&] {
            struct stat status {};
            REQUIRE(::stat(file.c_str(), &status) == 0);
            return status.st_gid;
        };
        for (const mode_t mode : {0777, 0640, 0600, 04755, 02755, 01644}) {
            write_all(file, "old");
            if (geteuid() == 0) REQUIRE(::chown(file.c_str(), 12, 34) == 0);
            REQUIRE(::chmod(file.c_str(), mode) == 0);
            const gid_t group = group_of();
            write_file_atomically(file, "new");
            struct stat status {};
            REQUIRE(::stat(file.c_str(), &status) == 0);
            CHECK((status.st_mode & 07777) == (mode & 0777));
            CHECK(status.st_gid == group);
            if (geteuid() == 0) CHECK(status.st_uid == 12);
        }
        const mode_t before = ::umask(027);
        write_file_atomically(folder / "fresh", "new");
        ::umask(before);
        CHECK(fs::status(folder / "fresh").permissions() == fs::perms(0640));
    }

    TEST_CASE("atomic file: an access control list stays") {
        const TemporaryFolder folder;
        const fs::path file = folder / "file";
        write_all(file, "old");
        REQUIRE(::chmod(file.c_str(), 0640) == 0);
        // Version 2; (tag, permissions, id): the owner may read and write, user 12 and the mask read, others
        // not.
        struct Entry {
            std::uint16_t tag, permissions;
            std::uint32_t id;
        };
        const std::uint32_t version = 2, nobody = ~0u;
        const Entry entries[] = {
            {0x01, 6, nobody}, {0x02, 4, 12}, {0x04, 0, nobody}, {0x10, 4, nobody}, {0x20, 0, nobody}};
        std::string list(reinterpret_cast<const char*>(&version), sizeof version);
        list.append(reinterpret_cast<const char*>(entries), sizeof entries);
        constexpr const char* name = "system.posix_acl_access";
        if (::setxattr(file.c_str(), name, list.data(), list.size(), 0) != 0)
            return;  // the file system has none
        write_file_atomically(file, "new");
        std::string found(100, '\0');
        const ssize_t size = ::getxattr(file.c_str(), name, found.data(), found.size());
        REQUIRE(size >= 0);
        CHECK(found.substr(0, static_cast<std::size_t>(size)) == list);
        CHECK(fs::status(file).permissions() == fs::perms(0640));
        CHECK(read_all(file) == "new");
    }

    TEST_CASE("atomic file: what a killed program left is removed, and nothing else") {
        const TemporaryFolder folder;
        const std::string left = ".nacre-4711-0123456789abcdef", alive = ".nacre-4711-fedcba9876543210";
        write_all(folder / left, "half");
        write_all(folder / alive, "half");
        const int descriptor = ::open((folder / alive).c_str(), O_RDONLY);
        REQUIRE(::flock(descriptor, LOCK_EX) == 0);
        const char* others[] = {".nacre-notes",
                                ".nacre-4711-0123456789abcde",
                                ".nacre-4711-0123456789abcdef0",
                                ".nacre-4711-0123456789ABCDEF",
                                ".nacre--0123456789abcdef",
                                ".nacre-47x1-0123456789abcdef",
                                "x.nacre-4711-0123456789abcdef",
                                ".nacre-4711-0123456789abcdef.png"};
        for (const char* name : others) write_all(folder / name, "the user's");
        fs::create_directory(folder / ".nacre-1-0000000000000001");
        REQUIRE(mkfifo((folder / ".nacre-1-0000000000000002").c_str(), 0600) == 0);
        fs::create_symlink("a.png", folder / ".nacre-1-0000000000000003");
        const std::size_t rest = folder.size() - 1;
        SUBCASE("by one file") { write_file_atomically(folder / "a.png", "new"); }
        SUBCASE("by a numbered file") { write_numbered_file(folder.path(), "a", ".png", "new"); }
        SUBCASE("by files together") { write_files_atomically({{folder / "a.png", "new"}}); }
        CHECK(!fs::exists(folder / left));
        CHECK(folder.size() == rest + 1);
        CHECK(read_all(folder / alive) == "half");
        for (const char* name : others) CHECK(read_all(folder / name) == "the user's");
        ::close(descriptor);
        write_file_atomically(folder / "a.png", "newer");
        CHECK(!fs::exists(folder / alive));
    }

    TEST_CASE("atomic file: several files are replaced together or not at all") {
        const TemporaryFolder folder;
        const std::vector<FileToWrite> files = {
            {folder / "a.exr", "new a"}, {folder / "b.exr", "new b"}, {folder / "manifest.json", "new"}};
        write_files_atomically(files);
        CHECK(read_all(folder / "b.exr") == "new b");
        CHECK(folder.size() == 3);
        write_all(folder / "a.exr", "old a");
        write_all(folder / "manifest.json", "old");
        fs::remove(folder / "b.exr");
        fs::create_directory(folder / "b.exr");
        CHECK(user_error_of([&] { write_files_atomically(files); }).starts_with((folder / "b.exr").string()));
        {
            const FileSizeLimit limit(4);
            fs::remove(folder / "b.exr");
            CHECK(user_error_of([&] {
                      write_files_atomically(files);
                  }).starts_with((folder / "a.exr").string()));
        }
        CHECK(read_all(folder / "a.exr") == "old a");
        CHECK(read_all(folder / "manifest.json") == "old");
        CHECK(folder.size() == 2);
        write_files_atomically(files);
        CHECK(read_all(folder / "a.exr") == "new a");
        CHECK(read_all(folder / "b.exr") == "new b");
        CHECK(read_all(folder / "manifest.json") == "new");
        CHECK(folder.size() == 3);
        write_files_atomically({});
    }

    TEST_CASE("atomic file: a numbered file takes the first free number and replaces nothing") {
        const TemporaryFolder folder;
        write_all(folder / "a-001.png", "first");
        fs::create_symlink("nowhere", folder / "a-002.png");
        CHECK(write_numbered_file(folder.path(), "a", ".png", "third") == folder / "a-003.png");
        CHECK(read_all(folder / "a-001.png") == "first");
        CHECK(read_all(folder / "a-003.png") == "third");
        CHECK(folder.size() == 3);
        CHECK(user_error_of([&] { write_numbered_file(folder / "none", "a", ".png", ""); }).find("a.png") !=
              std::string::npos);
    }

    TEST_CASE("atomic file: a picture on a full disk is an error, with the old one as it was") {
        const TemporaryFolder folder;
        const std::vector<float> rgb(64 * 64 * 3, 0.25f);
        for (const char* name : {"a.png", "a.exr"}) {
            write_image(folder / name, {64, 64}, rgb);
            const std::string old = read_all(folder / name);
            REQUIRE(old.size() > 100);
            std::vector<float> noise = rgb;
            for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<float>(i % 251) / 251;
            std::string line;
            {
                const FileSizeLimit limit(old.size() + 10);
                line = user_error_of([&] { write_image(folder / name, {64, 64}, noise); });
            }
            CHECK(line.find("(File too large)") != std::string::npos);
            CHECK(read_all(folder / name) == old);
        }
        CHECK(folder.size() == 2);
    }
}
