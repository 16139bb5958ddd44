// Headers that core/formats/c_header.h writes, compiled by the system's C compiler and run.
#pragma once

#include <fmt/core.h>
#include <stdio.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/temporary_folder.h"

namespace nacre::test {

// What a command says on both streams; `code` becomes what it returns.
inline std::string said_by(const std::string& command, int& code) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + command);
    std::string said;
    char part[4096];
    while (const std::size_t count = fread(part, 1, sizeof part, pipe)) said.append(part, count);
    code = pclose(pipe);
    return said;
}

inline constexpr const char* strict_c = "cc -std=c99 -pedantic -Wall -Wextra -Werror";
inline constexpr const char* strict_cpp = "c++ -x c++ -std=c++17 -pedantic -Wall -Wextra -Werror";

// A program that reads doubles from its first argument and writes doubles to its second one.
class CompiledC {
  public:
    // `source` may include the headers by their names.
    CompiledC(const std::vector<std::pair<std::string, std::string>>& headers, const std::string& source,
              const std::string& compiler = strict_c) {
        for (const auto& [name, text] : headers) write_all(folder_ / name, text);
        write_all(folder_ / "main.c", source);
        int code = 0;
        said = said_by(fmt::format("cd '{}' && {} -O2 main.c -o main -lm", folder_.path().string(), compiler),
                       code);
        if (code != 0) said += " (it failed)";
    }

    std::vector<double> operator()(std::span<const double> numbers) const {
        write_all(folder_ / "in", {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()});
        int code = 0;
        const std::string words =
            said_by(fmt::format("cd '{}' && ./main in out", folder_.path().string()), code);
        if (code != 0) throw std::runtime_error("the compiled program failed: " + words);
        const std::string bytes = read_all(folder_ / "out");
        std::vector<double> result(bytes.size() / sizeof(double));
        std::copy_n(bytes.data(), result.size() * sizeof(double), reinterpret_cast<char*>(result.data()));
        return result;
    }

    std::string said;  // by the compiler: nothing where all is well

  private:
    TemporaryFolder folder_;
};

}  // namespace nacre::test
