// Whatever system call fails, a file is the old one or the new one, and the outcome is told rightly.
#include "tests/faults/fault.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cstring>
#include <functional>
#include <map>

#include "app/designer/autosave.h"
#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/formats/export_format.h"
#include "core/image/image_file.h"
#include "tests/cli/child_process.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

constexpr mode_t old_mode = 0640;

using Files = std::map<std::string, std::string>;  // bytes by name, below a folder

Files files_in(const fs::path& folder) {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files[fs::relative(entry.path(), folder)] = read_all(entry.path());
    return files;
}

void put(const Files& files, const fs::path& folder) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (const auto& [name, bytes] : files) {
        fs::create_directories((folder / name).parent_path());
        write_all(folder / name, bytes);
        REQUIRE(::chmod((folder / name).c_str(), old_mode) == 0);
    }
}

bool has_temporary(const Files& files) {
    for (const auto& [name, bytes] : files)
        if (fs::path(name).filename().string().starts_with(".nacre-")) return true;
    return false;
}

Files without_temporary(Files files) {
    std::erase_if(files, [](const auto& file) {
        return fs::path(file.first).filename().string().starts_with(".nacre-");
    });
    return files;
}

struct Outcome {
    bool met = false;   // the call that was to fail came
    std::string error;  // the line that was told, empty where it was said to be done
};

Outcome with_fault(const Fault& fault, const std::function<void()>& work) {
    Outcome outcome;
    begin_fault(fault);
    try {
        work();
    } catch (const UserError& error) {
        outcome.error = error.what();
    }
    outcome.met = end_fault();
    return outcome;
}

// The outcome of one failing call, `work` making `made` of `old`.
void check_outcome(const Fault& fault, const Outcome& outcome, const fs::path& folder, const Files& old,
                   const Files& made) {
    const Files found = files_in(folder);
    const bool done = outcome.error.empty();
    CHECK(without_temporary(found) == (done ? made : old));
    if (fault.call != "unlink") CHECK(!has_temporary(found));
    if (!done) CHECK(outcome.error.find(std::strerror(fault.error)) != std::string::npos);
    if (!done) CHECK(outcome.error.find(folder.string()) == 0);
    if (!done && old.empty() && fault.call != "unlink") CHECK(fs::is_empty(folder));
    const bool passes = fault.error == EINTR || fault.error == 0;
    if (passes && (fault.call == "write" || fault.call == "open" || fault.call.starts_with("rename")))
        CHECK(done);
    if (!passes && fault.call == "write") CHECK(!done);
    if (done)
        for (const auto& [name, bytes] : old) {
            struct stat status {};
            REQUIRE(::stat((folder / name).c_str(), &status) == 0);
            CHECK((status.st_mode & 07777) == old_mode);
        }
}

// The errors take turns; an interruption is tried everywhere, and so is a write that does half of its work.
std::vector<int> errors_of(const std::string& call, int number) {
    constexpr int errors[] = {ENOSPC, EIO, EDQUOT, EROFS, EACCES};
    std::vector<int> chosen = {errors[static_cast<std::size_t>(number) % std::size(errors)]};
    const bool interruptible = call != "stat" && call != "fstat" && call != "access" && call != "opendir";
    if (interruptible) chosen.push_back(EINTR);
    if (call == "write") chosen.push_back(0);
    return chosen;
}

// Every call in turn. Returns how many failed.
int fail_everything(const Files& old, const std::function<void(const fs::path&)>& work) {
    const TemporaryFolder home;
    const fs::path folder = home / "out";
    put(old, folder);
    work(folder);
    const Files made = files_in(folder);
    REQUIRE(made != old);
    int met = 0;
    for (const std::string& call : fault_calls()) {
        bool comes = true;
        for (int number = 1; comes; ++number)
            for (const int error : errors_of(call, number)) {
                const Fault fault{call, number, error, folder.string()};
                put(old, folder);
                const Outcome outcome = with_fault(fault, [&] { work(folder); });
                comes = outcome.met;
                if (!comes) break;
                ++met;
                CAPTURE(call);
                CAPTURE(number);
                CAPTURE(std::string(std::strerror(error)));
                CAPTURE(outcome.error);
                check_outcome(fault, outcome, folder, old, made);
            }
    }
    return met;
}

// As the preloaded library takes it.
std::string first(const std::string& call, int error) { return call + " 1 " + std::to_string(error); }

Design design_named(const std::string& name) {
    Design design;
    design.name = name;
    design.distribution.layers[0].lobe = BeckmannLobe{0.3, 0.3};
    return design;
}

}  // namespace

TEST_CASE("faults: a save is the old file or the new one") {
    const auto save = [](const fs::path& folder) { save_design(design_named("new"), folder / "a.nacre"); };
    CHECK(fail_everything({{"a.nacre", "old"}}, save) > 20);
    CHECK(fail_everything({}, save) > 10);
}

TEST_CASE("faults: an autosave is the old file or the new one") {
    const auto autosave = [](const fs::path& folder) {
        write_autosave({design_named("new"), folder / "a.nacre"}, folder / autosave_name);
    };
    CHECK(fail_everything({{std::string(autosave_name), "old"}}, autosave) > 20);
}

TEST_CASE("faults: a picture is the old file or the new one") {
    const std::vector<float> rgb(16 * 16 * 3, 0.5f);
    for (const char* name : {"a.png", "a.exr"})
        CHECK(fail_everything({{name, "old"}}, [&](const fs::path& folder) {
                  write_image(folder / name, {16, 16}, rgb);
              }) > 20);
}

TEST_CASE("faults: an export of several files is all of the old ones or all of the new ones") {
    for (const ExportFormat* format : export_formats()) {
        const std::string output = "out" + std::string(format->extension);
        Design changed = design_named("new");
        changed.specular.intensity = 0.5;  // a format may have no place for a name
        const ExportWriter write[] = {format->prepare(design_named("old"), {.bake = {.threads = 1}}, {}, {}),
                                      format->prepare(changed, {.bake = {.threads = 1}}, {}, {})};
        const TemporaryFolder folder;
        write[0](folder / output);
        const Files old = files_in(folder.path());
        const auto again = [&](const fs::path& to) { write[1](to / output); };
        CHECK(fail_everything(old, again) > 20);
        CHECK(fail_everything({}, again) > 10);
        Files some = old;  // as an earlier version with fewer tables left them
        some.erase(std::prev(some.end()));
        if (some.size() > 1) CHECK(fail_everything(some, again) > 20);
    }
}

// A sanitizer's library has to come before any that is preloaded.
#ifdef NACRE_SANITIZED
constexpr bool can_preload = false;
#else
constexpr bool can_preload = true;
#endif

TEST_CASE("faults: nacre-cli ends with 1, one line and the old file" * doctest::skip(!can_preload)) {
    const TemporaryFolder folder;
    const std::string design = (folder / "d.nacre").string();
    save_design(design_named("d"), design);
    fs::create_directory(folder / "out");
    const fs::path output = folder / "out/a";
    const std::vector<std::vector<std::string>> verbs = {
        {"export", design, "--to", "glsl", "-o", output},
        {"plot", design, "--what", "density", "-o", output.string() + ".svg"},
        {"render", design, "--size", "32x32", "-o", output.string() + ".png"}};
    for (const std::vector<std::string>& verb : verbs)
        for (const std::string& fault :
             {first("write", ENOSPC), first("fsync", EDQUOT), first("rename", EIO), first("open", EROFS)}) {
            CAPTURE(fault);
            write_all(verb.back(), "old");
            const Finished finished =
                run_cli(verb, {.environment = {"LD_PRELOAD=" NACRE_FAULT_LIBRARY, "NACRE_FAULT=" + fault,
                                               "NACRE_FAULT_FOLDER=" + (folder / "out").string()}});
            CHECK(finished.code == 1);
            CHECK_MESSAGE(is_one_line_with(finished.err, {verb.back() + ": write: "}), finished.err);
            CHECK(files_in(folder / "out") == Files{{fs::path(verb.back()).filename(), "old"}});
            fs::remove(verb.back());
        }
}
