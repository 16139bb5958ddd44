// Kill -9 at any moment: what was kept is whole, and at most the last stroke is lost.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/designer/autosave.h"
#include "app/designer/recent_files.h"
#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/crash/exports.h"
#include "tests/crash/numbered_design.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

// A hundred kills in all; NACRE_CRASH_KILLS asks for more or fewer.
int kills(double part) {
    const char* wanted = std::getenv("NACRE_CRASH_KILLS");
    const int all = wanted != nullptr ? std::atoi(wanted) : 100;
    return std::max(1, static_cast<int>(std::lround(part * all)));
}

// The times are other ones for each NACRE_CRASH_SEED.
unsigned seed(unsigned test) {
    const char* wanted = std::getenv("NACRE_CRASH_SEED");
    return test + 10 * static_cast<unsigned>(wanted != nullptr ? std::atoi(wanted) : 0);
}

class Child {
  public:
    Child(const std::string& mode, const fs::path& folder) {
        int ends[2];
        REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
        output_ = ends[0];
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        std::string words[] = {NACRE_CRASH_CHILD, mode, folder.string()};
        char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
        REQUIRE(posix_spawn(&id_, NACRE_CRASH_CHILD, &actions, nullptr, arguments, environ) == 0);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
    }
    ~Child() {
        if (id_ > 0) kill();
        close(output_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Until it has told this.
    void wait_for(const std::string& text) {
        while (told_.find(text) == std::string::npos) {
            pollfd waiting{output_, POLLIN, 0};
            REQUIRE(poll(&waiting, 1, 60'000) == 1);
            REQUIRE_MESSAGE(read_some() > 0, "the child ended by itself");
        }
    }

    // All lines that it has told.
    std::vector<std::string> kill() {
        ::kill(id_, SIGKILL);
        int status = 0;
        waitpid(id_, &status, 0);
        id_ = -1;
        CHECK_MESSAGE(WIFSIGNALED(status), "the child ended by itself");
        while (read_some() > 0) {
        }
        std::istringstream text(told_);
        std::vector<std::string> lines;
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }

  private:
    ssize_t read_some() {
        char bytes[4096];
        const ssize_t got = read(output_, bytes, sizeof bytes);
        if (got > 0) told_.append(bytes, static_cast<std::size_t>(got));
        return got;
    }

    pid_t id_ = -1;
    int output_ = -1;
    std::string told_;
};

// Kills a child somewhere in the `seconds` after it has told this.
std::vector<std::string> kill_one(const std::string& mode, const fs::path& folder, double seconds,
                                  std::mt19937& random, const std::string& told = "ready\n") {
    Child child(mode, folder);
    child.wait_for(told);
    const double after = std::uniform_real_distribution<double>(0, seconds)(random);
    std::this_thread::sleep_for(std::chrono::duration<double>(after));
    return child.kill();
}

// What the next start would offer. More than one work in the folder is a failure.
std::optional<Design> recovered(const fs::path& folder) {
    std::optional<Design> found;
    for (LockedDirectory& orphan : claim_abandoned(folder)) {
        const fs::path file = orphan.path() / autosave_name;
        if (!fs::exists(file)) continue;
        CHECK(!found);
        found = read_autosave(file).design;  // throws where it is damaged
    }
    return found;
}

struct Told {
    std::map<int, std::uint64_t> digests;  // of each stroke
    int last = 0;
};

Told strokes_told(const std::vector<std::string>& lines, const std::string& before) {
    Told told;
    for (const std::string& line : lines) {
        if (!line.starts_with(before) || line == "ready" || line.starts_with("saved")) continue;
        std::istringstream words(line.substr(before.size()));
        std::uint64_t digest = 0;
        words >> told.last >> digest;
        told.digests[told.last] = digest;
    }
    return told;
}

bool is_whole(const Design& design, const Told& told) {
    const auto known = told.digests.find(stroke_of(design));
    return known == told.digests.end() || known->second == digest(design);
}

// A manifest tells how long the bake took, which is another time in each process.
std::string without_time(std::string text) {
    const std::size_t at = text.find("seconds\":");
    if (at != std::string::npos && text.starts_with('{')) text.erase(at, text.find_first_of(",}\n", at) - at);
    return text;
}

std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (entry.is_regular_file() && name.find(".nacre-") == std::string::npos)
            files[name] = without_time(read_all(entry.path()));
    }
    return files;
}

std::ptrdiff_t temporary_files(const fs::path& folder) {
    return std::count_if(fs::recursive_directory_iterator(folder), {}, [](const fs::directory_entry& entry) {
        return entry.path().filename().string().starts_with(".nacre-");
    });
}

}  // namespace

TEST_CASE("crash: killed while painting, at most the last stroke is lost") {
    std::mt19937 random(seed(1));
    int with_work = 0;
    for (int i = 0; i < kills(0.34); ++i) {
        const TemporaryFolder folder;
        // However slow the machine is, some have painted.
        const std::string begun = i % 2 == 0 ? "\n2 " : "ready\n";
        const Told told = strokes_told(kill_one("paint", folder.path(), 0.5, random, begun), "");
        const std::optional<Design> found = recovered(folder / "unsaved");
        const int stroke = found ? stroke_of(*found) : 0;
        CAPTURE(i);
        CHECK(stroke >= told.last - 1);
        CHECK(stroke <= told.last + 1);
        if (found) CHECK(is_whole(*found, told));
        with_work += found.has_value();
    }
    CHECK(with_work > 0);
}

TEST_CASE("crash: killed while saving, the file is the last save or the one before it") {
    std::mt19937 random(seed(2));
    for (int i = 0; i < kills(0.33); ++i) {
        const TemporaryFolder folder;
        const std::vector<std::string> lines = kill_one("save", folder.path(), 0.25, random);
        const Told told = strokes_told(lines, "began ");
        int saved = 0;
        for (const std::string& line : lines)
            if (line.starts_with("saved ")) saved = std::stoi(line.substr(6));
        CAPTURE(i);
        std::optional<Design> file;
        if (fs::exists(folder / "work.nacre")) file = load_design(folder / "work.nacre");
        REQUIRE(file);
        const int in_file = stroke_of(*file);
        CHECK(in_file >= saved);
        CHECK(in_file <= saved + 1);
        CHECK(is_whole(*file, told));
        if (const auto found = recovered(folder / "unsaved")) CHECK(is_whole(*found, told));
        const RecentFiles recent(folder / "state");
        CHECK(recent.problem().empty());
        CHECK(recent.files() == std::vector<fs::path>{folder / "work.nacre"});
    }
}

TEST_CASE(
    "crash: killed while exporting, files are whole, beside their manifest, and the next export tidies up") {
    std::mt19937 random(seed(3));
    const Exports exports;
    std::map<std::string, std::string> expected[2];
    for (int which = 0; which < 2; ++which) {
        const TemporaryFolder folder;
        exports.write(which, folder.path());
        expected[which] = contents(folder.path());
    }
    REQUIRE(expected[0] != expected[1]);
    std::ptrdiff_t left_behind = 0;
    for (int i = 0; i < kills(0.33); ++i) {
        const TemporaryFolder folder;
        kill_one("export", folder.path(), 0.15, random);
        CAPTURE(i);
        const auto found = contents(folder.path());
        for (const auto& [name, bytes] : found) {
            const bool whole = bytes == expected[0][name] || bytes == expected[1][name];
            CHECK_MESSAGE(whole, name);
        }
        const auto manifest = found.find("out-exr/manifest.json");
        if (manifest != found.end()) {
            auto& like = manifest->second == expected[0][manifest->first] ? expected[0] : expected[1];
            for (const auto& [name, bytes] : found)
                if (name.starts_with("out-exr/")) CHECK_MESSAGE(bytes == like[name], name);
        }
        CHECK(!found.empty());
        left_behind += temporary_files(folder.path());
        exports.write(1, folder.path());
        CHECK(temporary_files(folder.path()) == 0);
        CHECK(contents(folder.path()) == expected[1]);
    }
    CHECK((left_behind > 0 || kills(0.33) < 10));
}
