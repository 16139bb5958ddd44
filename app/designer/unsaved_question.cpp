#include "app/designer/unsaved_question.h"

#include "ui/dialogs.h"

namespace nacre {
namespace {

std::optional<UnsavedAnswer> ask(const std::string& text, const char* keep) {
    const auto answer = ui::question("Unsaved changes", text, {keep, "Discard", "Cancel"});
    if (!answer) return {};
    return static_cast<UnsavedAnswer>(*answer);
}

}  // namespace

std::optional<UnsavedAnswer> ask_about_unsaved(const std::string& name) {
    return ask("\u201c" + name + "\u201d has changes that are not saved.", "Save");
}

std::optional<UnsavedAnswer> ask_about_unsaved_elsewhere(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += "\u201c" + name + "\u201d, ";
    text += names.size() > 1 ? "the designs before this one, have" : "the design before this one, has";
    return ask(text + " changes that are not saved.", "Bring back");
}

}  // namespace nacre
