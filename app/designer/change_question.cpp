#include "app/designer/change_question.h"

#include <string>
#include <vector>

#include "ui/dialogs.h"

namespace nacre {
namespace {

struct Choice {
    const char* label;
    ChangeAnswer answer;
};

// Enter takes the first, Escape the last.
std::vector<Choice> choices(bool gone, bool saving) {
    using enum ChangeAnswer;
    if (!saving) {
        if (gone) return {{"Save again", overwrite}, {"Keep mine", keep_mine}};
        return {{"Reload", reload}, {"Keep mine", keep_mine}};
    }
    if (gone) return {{"Save again", overwrite}, {"Save as\u2026", save_as}, {"Cancel", cancel}};
    return {{"Reload", reload}, {"Save as\u2026", save_as}, {"Overwrite", overwrite}, {"Cancel", cancel}};
}

std::string text_of(const std::string& name, bool gone, bool saving) {
    std::string text = "\u201c" + name + "\u201d ";
    if (gone) {
        text += "is gone from the disk, or cannot be read any more. Your work is still here.";
        return saving ? text : text + " Keep mine marks it as unsaved.";
    }
    text +=
        "was changed by another program since it was read or saved here. "
        "Reload takes what the file holds now; Undo brings yours back.";
    return text + (saving ? " Overwrite replaces what the file holds now."
                          : " Keep mine leaves the file as it is until you save.");
}

}  // namespace

std::optional<ChangeAnswer> ask_about_change(const std::filesystem::path& file, bool gone, bool saving) {
    const std::vector<Choice> all = choices(gone, saving);
    std::vector<std::string> labels;
    for (const Choice& choice : all) labels.emplace_back(choice.label);
    const auto pressed = ui::question(gone ? "Design gone from the disk" : "Design changed on the disk",
                                      text_of(file.filename().string(), gone, saving), labels);
    if (!pressed) return {};
    return all[static_cast<std::size_t>(*pressed)].answer;
}

}  // namespace nacre
