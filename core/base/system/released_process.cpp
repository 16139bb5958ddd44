#include "core/base/system/released_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace nacre {
namespace {

// A session of its own: the signals of our terminal do not reach it.
class Detached {
  public:
    Detached() {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawnattr_init(&attributes_);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID);
    }
    ~Detached() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    Detached(const Detached&) = delete;
    Detached& operator=(const Detached&) = delete;

    // Its number, or -1.
    int spawn(const char* program, char** words) const {
        int child = -1;
        return ::posix_spawn(&child, program, &actions_, &attributes_, words, environ) == 0 ? child : -1;
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

ReleasedProcess::ReleasedProcess(const std::filesystem::path& program, std::vector<std::string> words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    child_ = Detached().spawn(program.c_str(), pointers.data());
}

std::optional<ReleasedProcess::Ended> ReleasedProcess::poll() {
    if (child_ < 0) return Ended{};
    int status = 0;
    if (::waitpid(child_, &status, WNOHANG) != child_) return {};
    child_ = -1;
    Ended ended;
    if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
    return ended;
}

}  // namespace nacre
