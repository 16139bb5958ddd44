#include "app/designer/system_dialog.h"

#include <cctype>
#include <string_view>
#include <utility>

#include "app/designer/program_in_path.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::FileDialog::Purpose;

std::string capitals(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

// "Plot | *.svg *.SVG *.csv *.CSV": zenity's patterns are case-sensitive.
std::string zenity_filter(const FileQuestion& question) {
    std::string filter = question.kind + " |";
    for (const std::string& extension : question.extensions)
        filter += " *" + extension + " *" + capitals(extension);
    return filter;
}

// "*.svg *.csv": kdialog ignores case.
std::string kdialog_filter(const FileQuestion& question) {
    std::string filter;
    for (const std::string& extension : question.extensions)
        filter += (filter.empty() ? "*" : " *") + extension;
    return filter;
}

std::vector<std::string> zenity_arguments(const FileQuestion& question) {
    std::vector<std::string> words = {"zenity", "--file-selection", "--title=" + question.title};
    if (question.purpose == Purpose::save) words.emplace_back("--save");
    if (question.purpose == Purpose::folder) words.emplace_back("--directory");
    // A folder's name ends in a slash, else its last part is taken for a file.
    if (!question.folder.empty())
        words.push_back("--filename=" + (question.folder / question.name).string());
    else if (!question.name.empty())
        words.push_back("--filename=" + question.name);
    if (!question.extensions.empty()) words.push_back("--file-filter=" + zenity_filter(question));
    return words;
}

std::vector<std::string> kdialog_arguments(const FileQuestion& question) {
    const char* verb = question.purpose == Purpose::open   ? "--getopenfilename"
                       : question.purpose == Purpose::save ? "--getsavefilename"
                                                           : "--getexistingdirectory";
    const fs::path start = question.folder.empty() ? fs::path(".") : question.folder;
    std::vector<std::string> words = {"kdialog", "--title", question.title, verb,
                                      (start / question.name).string()};
    if (!question.extensions.empty()) words.push_back(kdialog_filter(question));
    return words;
}

}  // namespace

std::optional<DialogProgram> find_dialog_program(const EnvironmentVariables& environment) {
    if (!has_display(environment)) return {};
    using enum DialogProgram::Kind;
    const char* desktop = environment("XDG_CURRENT_DESKTOP");
    const bool kde = desktop != nullptr && std::string_view(desktop).find("KDE") != std::string_view::npos;
    std::vector<std::pair<DialogProgram::Kind, const char*>> order = {{zenity, "zenity"},
                                                                      {kdialog, "kdialog"}};
    if (kde) std::swap(order[0], order[1]);
    for (const auto& [kind, name] : order)
        if (const fs::path file = program_in_path(environment, name); !file.empty())
            return DialogProgram{kind, file};
    return {};
}

std::vector<std::string> dialog_arguments(const DialogProgram& program, const FileQuestion& question) {
    return program.kind == DialogProgram::Kind::zenity ? zenity_arguments(question)
                                                       : kdialog_arguments(question);
}

SystemDialog::SystemDialog(const DialogProgram& program, const FileQuestion& question)
    : child_(program.file, dialog_arguments(program, question)) {}

SystemDialog::State SystemDialog::poll() {
    if (state_ != State::open) return state_;
    if (auto ended = child_.poll()) state_ = finished(std::move(*ended));
    return state_;
}

SystemDialog::State SystemDialog::finished(ChildProcess::Ended ended) {
    if (ended.code == 1) return State::cancelled;
    if (ended.output.ends_with('\n')) ended.output.pop_back();
    chosen_ = ended.output;
    return ended.code == 0 && chosen_.is_absolute() ? State::accepted : State::failed;
}

}  // namespace nacre
