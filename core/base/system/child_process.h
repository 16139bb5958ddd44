// Another program, started with a list of arguments and asked now and then whether it has ended.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nacre {

// Whether the user may run the file.
bool is_executable(const std::filesystem::path& file);

class ChildProcess {
  public:
    // `words`: its arguments, its own name first. It reads nothing, and what it says on standard error is
    // lost.
    ChildProcess(const std::filesystem::path& program, std::vector<std::string> words);
    ~ChildProcess();  // ends it
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    struct Ended {
        std::optional<int> code;  // none where it did not start or a signal ended it
        std::string output;       // what it wrote to standard output, up to 64 KiB and a little more
    };
    // Nothing while it runs. Never waits; reports the end once.
    std::optional<Ended> poll();

  private:
    int child_ = -1;
    int output_ = -1;  // our end of the pipe that its answer comes through
    std::string answer_;
};

}  // namespace nacre
