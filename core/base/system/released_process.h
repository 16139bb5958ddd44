// Another program that goes on when this one ends, as a file manager does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nacre {

class ReleasedProcess {
  public:
    // `words`: its arguments, its own name first. It reads nothing, and what it says is lost.
    ReleasedProcess(const std::filesystem::path& program, std::vector<std::string> words);

    struct Ended {
        std::optional<int> code;  // none where it did not start or a signal ended it
    };
    // Nothing while it runs. Never waits; reports the end once.
    std::optional<Ended> poll();

  private:
    int child_ = -1;
};

}  // namespace nacre
