#include "core/base/system/file_content.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include "tests/core/temporary_folder.h"

using namespace nacre;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;
namespace fs = std::filesystem;

TEST_CASE("file content: a file holds what its bytes are, of any length") {
    const TemporaryFolder folder;
    std::string bytes;
    for (const std::size_t length :
         {0u, 1u, 7u, 8u, 9u, (1u << 20) - 1, 1u << 20, (1u << 20) + 1, 3000000u}) {
        while (bytes.size() < length) bytes += static_cast<char>(bytes.size() * 131 >> 3);
        write_all(folder / "a", bytes);
        CHECK(content_of_file(folder / "a") == content_of(bytes));
        CHECK(content_of(bytes).bytes == length);
    }
}

TEST_CASE("file content: every single bit counts, and where zeros end") {
    std::set<std::uint64_t> digests = {content_of(std::string(64, '\0')).digest};
    for (std::size_t i = 0; i < 64; ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string bytes(64, '\0');
            bytes[i] = static_cast<char>(1 << bit);
            digests.insert(content_of(bytes).digest);
        }
    CHECK(digests.size() == 64 * 8 + 1);
    CHECK(content_of(std::string(3, '\0')) != content_of(std::string(4, '\0')));
}

TEST_CASE("file content: found by the bytes, whatever the times say") {
    const TemporaryFolder folder;
    write_all(folder / "a", "one");
    const auto before = content_of_file(folder / "a");
    const auto time = fs::last_write_time(folder / "a");
    write_all(folder / "a", "two");
    fs::last_write_time(folder / "a", time);
    CHECK(content_of_file(folder / "a") != before);
    write_all(folder / "a", "one");
    fs::last_write_time(folder / "a", time + std::chrono::hours(1));
    CHECK(content_of_file(folder / "a") == before);
}

TEST_CASE("file content: what is no regular file holds nothing, and is not waited for") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    for (const fs::path& file :
         {folder / "pipe", folder / "missing", folder.path(), fs::path("/dev/zero"), fs::path()})
        CHECK(!content_of_file(file));
    write_all(folder / "a", "one");
    const HeldFiles held = held_now(std::vector<fs::path>{folder / "a", folder / "missing"});
    CHECK(held.size() == 1);
    CHECK(content_in(held, folder / "a") == content_of("one"));
    CHECK(!content_in(held, folder / "missing"));
}

TEST_CASE("file content: as text and back") {
    for (const std::string& bytes : {std::string(), std::string("a"), std::string(100000, 'x')})
        CHECK(parse_content(content_text(content_of(bytes))) == content_of(bytes));
    for (const char* wrong : {"", "-", "1-", "-1", "1-2", "1-000000000000000g", "01-0000000000000000",
                              "1-0000000000000000 ", "-1-0000000000000000", "1-00000000000000000"})
        CHECK(!parse_content(wrong));
}
