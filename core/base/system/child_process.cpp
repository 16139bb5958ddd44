#include "core/base/system/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>

namespace nacre {
namespace {

constexpr std::size_t output_max = 1 << 16;  // bytes

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

bool is_executable(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

ChildProcess::ChildProcess(const std::filesystem::path& program, std::vector<std::string> words) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return;
    output_ = ends[0];
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
    const SpawnActions actions(ends[1]);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    if (::posix_spawn(&child_, program.c_str(), actions.get(), nullptr, pointers.data(), environ) != 0)
        child_ = -1;
    ::close(ends[1]);
}

ChildProcess::~ChildProcess() {
    if (child_ > 0) {
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
    }
    if (output_ >= 0) ::close(output_);
}

std::optional<ChildProcess::Ended> ChildProcess::poll() {
    if (child_ < 0) return Ended{};
    char bytes[4096];
    ssize_t got = 0;
    while ((got = ::read(output_, bytes, sizeof bytes)) > 0 && answer_.size() < output_max)
        answer_.append(bytes, static_cast<std::size_t>(got));
    if (got < 0 && errno == EAGAIN) return {};
    int status = 0;
    if (::waitpid(child_, &status, WNOHANG) != child_) return {};
    child_ = -1;
    Ended ended{.code = {}, .output = std::move(answer_)};
    if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
    return ended;
}

}  // namespace nacre
