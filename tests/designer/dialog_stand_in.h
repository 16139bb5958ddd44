// Questions for files, asked by hand and answered by a program that stands in for the desktop's dialogs.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

namespace nacre::test {

// A program that writes down what it was started with and answers when it is told to.
class StandIn {
  public:
    explicit StandIn(DialogProgram::Kind kind = DialogProgram::Kind::zenity)
        : program_{kind, folder_ / "dialog"} {
        std::filesystem::copy_file(NACRE_SOURCE_DIR "/tests/designer/dialog_stand_in.sh", program_.file);
        std::filesystem::permissions(program_.file, std::filesystem::perms::owner_all);
    }

    const DialogProgram& program() const { return program_; }

    void answer(const std::filesystem::path& file) const { write_answer(file.string() + "\n"); }
    void cancel() const { write_answer(""); }
    void answer_no_more() const { std::filesystem::remove(folder_ / "answer"); }

    // Without its own name.
    std::vector<std::string> arguments() const {
        std::ifstream stream(folder_ / "arguments");
        std::vector<std::string> words;
        for (std::string word; std::getline(stream, word);) words.push_back(word);
        return words;
    }

  private:
    // At once whole.
    void write_answer(const std::string& text) const {
        write_all(folder_ / "answer.part", text);
        std::filesystem::rename(folder_ / "answer.part", folder_ / "answer");
    }

    TemporaryFolder folder_;
    DialogProgram program_;
};

// What a panel asks for a file, and how a hand gets it to ask.
struct Asking {
    const char* script;
    bool (*talking)(const Designer&);
    const std::string& (*problem)(const Designer&);
};

inline const Asking environment_map = {
    "click \"Light\"\nframes 2\nclick \"Environment\"\nframes 2\nclick \"Open picture\u2026\"\nframes 2",
    [](const Designer& d) { return d.environment.talking(); },
    [](const Designer& d) -> const std::string& { return d.environment.problem(); }};
inline const Asking object = {"click \"OBJ file\"\nframes 2",
                              [](const Designer& d) { return d.objects.talking(); },
                              [](const Designer& d) -> const std::string& { return d.objects.problem(); }};
inline const Asking plot = {"click \"Save plot\"\nframes 2",
                            [](const Designer& d) { return d.plots.saving.talking(); },
                            [](const Designer& d) -> const std::string& { return d.plots.saving.problem(); }};

// Asks, has it answered, and waits until the answer is taken and what follows from it is done.
inline void ask(Rig& r, const StandIn& dialog, const Asking& asking, const std::filesystem::path& answer) {
    dialog.answer_no_more();
    r.play(asking.script);
    REQUIRE(asking.talking(r.designer()));
    if (answer.empty())
        dialog.cancel();
    else
        dialog.answer(answer);
    REQUIRE(r.frames_until(
        [&] { return !asking.talking(r.designer()) || !asking.problem(r.designer()).empty(); }));
    r.play("wait\nframes 2");
}

}  // namespace nacre::test
