#include "app/designer/system_dialog.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <utility>

namespace nacre {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::FileDialog::Purpose;

constexpr std::size_t answer_max = 1 << 16;  // bytes of a path

fs::path program_in_path(const EnvironmentVariables& environment, const char* name) {
    const char* path = environment("PATH");
    for (std::string_view rest = path != nullptr ? path : ""; !rest.empty();) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const fs::path file = fs::path(rest.substr(0, end)) / name;
        rest.remove_prefix(std::min(end + 1, rest.size()));
        std::error_code error;
        if (file.is_absolute() && fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0)
            return file;
    }
    return {};
}

bool is_set(const EnvironmentVariables& environment, const char* variable) {
    const char* value = environment(variable);
    return value != nullptr && *value != '\0';
}

std::string capitals(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

// "Plot | *.svg *.SVG *.csv *.CSV": it tells small letters from capitals.
std::string zenity_filter(const FileQuestion& question) {
    std::string filter = question.kind + " |";
    for (const std::string& ending : question.endings) filter += " *" + ending + " *" + capitals(ending);
    return filter;
}

// "*.svg *.csv": of small letters or capitals.
std::string kdialog_filter(const FileQuestion& question) {
    std::string filter;
    for (const std::string& ending : question.endings) filter += (filter.empty() ? "*" : " *") + ending;
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
    if (!question.endings.empty()) words.push_back("--file-filter=" + zenity_filter(question));
    return words;
}

std::vector<std::string> kdialog_arguments(const FileQuestion& question) {
    const char* verb = question.purpose == Purpose::open   ? "--getopenfilename"
                       : question.purpose == Purpose::save ? "--getsavefilename"
                                                           : "--getexistingdirectory";
    const fs::path start = question.folder.empty() ? fs::path(".") : question.folder;
    std::vector<std::string> words = {"kdialog", "--title", question.title, verb,
                                      (start / question.name).string()};
    if (!question.endings.empty()) words.push_back(kdialog_filter(question));
    return words;
}

class SpawnActions {
  public:
    explicit SpawnActions(int output) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::optional<DialogProgram> find_dialog_program(const EnvironmentVariables& environment) {
    if (!is_set(environment, "DISPLAY") && !is_set(environment, "WAYLAND_DISPLAY")) return {};
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

SystemDialog::SystemDialog(const DialogProgram& program, const FileQuestion& question) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) {
        state_ = State::failed;
        return;
    }
    output_ = ends[0];
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
    const SpawnActions actions(ends[1]);
    std::vector<std::string> words = dialog_arguments(program, question);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    if (::posix_spawn(&child_, program.file.c_str(), actions.get(), nullptr, pointers.data(), environ) != 0) {
        child_ = -1;
        state_ = State::failed;
    }
    ::close(ends[1]);
}

SystemDialog::~SystemDialog() {
    if (child_ > 0) {
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
    }
    if (output_ >= 0) ::close(output_);
}

SystemDialog::State SystemDialog::poll() {
    if (state_ != State::open) return state_;
    char bytes[4096];
    ssize_t got = 0;
    while ((got = ::read(output_, bytes, sizeof bytes)) > 0 && answer_.size() < answer_max)
        answer_.append(bytes, static_cast<std::size_t>(got));
    if (got < 0 && errno == EAGAIN) return state_;
    int status = 0;
    if (::waitpid(child_, &status, WNOHANG) != child_) return state_;
    child_ = -1;
    return state_ = finished(status);
}

SystemDialog::State SystemDialog::finished(int status) {
    if (!WIFEXITED(status)) return State::failed;
    if (WEXITSTATUS(status) == 1) return State::cancelled;
    if (answer_.ends_with('\n')) answer_.pop_back();
    chosen_ = answer_;
    return WEXITSTATUS(status) == 0 && chosen_.is_absolute() ? State::accepted : State::failed;
}

}  // namespace nacre
