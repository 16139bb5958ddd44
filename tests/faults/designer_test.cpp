// What fails while the designer writes is told in one line, with the file and the reason.
#include <doctest/doctest.h>

#include <cstring>
#include <string>

#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"
#include "tests/faults/fault.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

struct FailingRig : Rig {
    TemporaryFolder folder;
    fs::path out = folder / "out";
    FailingRig() {
        fs::create_directory(out);
        designer().exporter.options().tolerance = 0.1;
        designer().exporter.options().width = designer().exporter.options().height = 64;
        play("wait");
        designer().files.tell("before");
    }

    std::string typed(const std::string& name) {
        return "frames 5\nkey Ctrl+A\ntext \"" + (out / name).string() + "\"\nkey Enter\nframes 3\n";
    }

    // Plays with this call failing in the folder.
    void play_with(const char* call, int error, const std::string& steps) {
        begin_fault({call, 1, error, out.string()});
        play(steps);
        CHECK(frames_until([&] {
            const Designer& d = designer();
            return !d.pictures_of_preview.in_motion() && !d.exporter.in_motion();
        }));
        CHECK(end_fault());
    }
};

struct Failure {
    const char* call;
    int error;
};
constexpr Failure failures[] = {{"write", ENOSPC}, {"fsync", EDQUOT}, {"rename", EROFS}};

// Of something in `file`'s folder; the line begins with its path.
void check_line(const std::string& line, const fs::path& file, int error) {
    CAPTURE(line);
    CHECK(line.starts_with(file.string() + ": write: "));
    CHECK(line.ends_with("(" + std::string(std::strerror(error)) + ")"));
    CHECK(line.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("faults: a picture of the preview that cannot be written is told") {
    FailingRig r;
    r.designer().settings.values.picture_folder = r.out;
    for (const Failure& failure : {Failure{"open", EACCES}, Failure{"write", ENOSPC}}) {
        CAPTURE(failure.call);
        r.play_with(failure.call, failure.error, "key F12\nframes 3");
        check_line(r.designer().pictures_of_preview.problem(), r.out / "untitled.png", failure.error);
        CHECK(r.designer().files.message() == "before");
        r.play("frames 3\nkey Enter\nframes 30");
    }
    r.designer().settings.values.picture_folder = r.out / "made/here";
    r.play_with("mkdir", EROFS, "key F12\nframes 3");
    check_line(r.designer().pictures_of_preview.problem(), r.out / "made/here", EROFS);
    r.play("frames 3\nkey Enter\nframes 30");
    r.play_with("write", ENOSPC, "key F12\nframes 3");
    check_line(r.designer().pictures_of_preview.problem(), r.out / "made/here/untitled.png", ENOSPC);
    CHECK(fs::is_empty(r.out));
}

TEST_CASE("faults: an export that cannot be written is told, and not as one that was stopped") {
    FailingRig r;
    struct Export {
        const char *format, *name, *written;
    };
    for (const Export& each :
         {Export{"GLSL function", "a.glsl", "a.glsl"}, Export{"Picture, PNG", "a.png", "a.png"},
          Export{"Picture, EXR", "a.exr", "a.exr"}})
        for (const Failure& failure : failures) {
            CAPTURE(each.format);
            CAPTURE(failure.call);
            r.play_with(failure.call, failure.error,
                        std::string("key Ctrl+E\nframes 30\nclick \"Format ") + each.format +
                            "\"\nframes 30\nclick \"Choose export file\"\n" + r.typed(each.name));
            check_line(r.designer().exporter.problem(), r.out / each.written, failure.error);
            CHECK(r.designer().files.message() == "before");
            r.play("frames 3\nkey Enter\nframes 30");
            CHECK(!r.designer().exporter.talking());
        }
    r.play_with("mkdir", EACCES,
                "key Ctrl+E\nframes 30\nclick \"Format Tables as EXR pictures\"\nframes 30\n"
                "click \"Choose export file\"\n" +
                    r.typed("tables"));
    check_line(r.designer().exporter.problem(), r.out / "tables", EACCES);
    CHECK(r.designer().files.message() == "before");
    CHECK(fs::is_empty(r.out));
}

TEST_CASE("faults: a plot and a design that cannot be written are told") {
    FailingRig r;
    r.play("click \"Plots\"\nclick \"Plot masking\"\nwait");
    for (const Failure& failure : failures) {
        CAPTURE(failure.call);
        r.play_with(failure.call, failure.error, "click \"Save plot\"\n" + r.typed("p.svg"));
        check_line(r.designer().plots.saving.problem(), r.out / "p.svg", failure.error);
        r.play("frames 3\nkey Enter\nframes 30");
        r.play_with(failure.call, failure.error, "key Ctrl+Shift+S\n" + r.typed("d.nacre"));
        check_line(r.designer().files.problem(), r.out / "d.nacre", failure.error);
        r.play("frames 3\nkey Enter\nframes 30");
    }
    CHECK(r.designer().files.message() == "before");
    CHECK(fs::is_empty(r.out));
}

TEST_CASE("faults: unsaved work, settings and recent files that cannot be kept are told with their files") {
    const TemporaryFolder home;
    const auto begin = [&](int error) { begin_fault({"write", 1, error, home.path().string()}); };
    Rig r({.bake_threads = 1, .folders = {.config = home / "config", .state = home / "state"}});
    begin(ENOSPC);
    r.document().design.name = "Edited";
    r.play("frames 2");
    r.designer().autosave.wait();
    r.play("frames 1");
    CHECK(end_fault());
    const std::string& autosave = r.designer().autosave.problem();
    CAPTURE(autosave);
    CHECK(autosave.starts_with((home / "state/unsaved").string()));
    CHECK(autosave.ends_with("unsaved.nacre: write: the file cannot be written (No space left on device)"));
    begin(EIO);
    r.designer().settings.values.system_dialogs = !r.designer().settings.values.system_dialogs;
    r.designer().settings.keep();
    CHECK(end_fault());
    check_line(r.designer().settings.problem(), home / "config/settings.json", EIO);
    begin(EDQUOT);
    r.designer().recent.note("/a.nacre");
    CHECK(end_fault());
    check_line(r.designer().recent.problem(), home / "state/recent.json", EDQUOT);
    const auto warning = [&] {
        r.play("move \"Said last\"\nframes 40");
        return r.stage.items().tooltip();
    };
    CHECK(warning() == "Unsaved work cannot be kept: " + autosave);
    r.document().design.name = "Edited again";
    r.play("frames 2");
    r.designer().autosave.wait();
    CHECK(warning() == "Settings: " + r.designer().settings.problem());
}
