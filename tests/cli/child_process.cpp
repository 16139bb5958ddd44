#include "tests/cli/child_process.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/core/file_size_limit.h"
#include "tests/core/temporary_folder.h"

namespace nacre::test {
namespace {

using Clock = std::chrono::steady_clock;

// Both ends of a pipe, closed when it goes.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    void close_end(std::size_t which) {
        if (ends[which] >= 0) ::close(ends[which]);
        ends[which] = -1;
    }
};

class Spawn {
  public:
    Spawn() {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        sigset_t defaults;
        sigemptyset(&defaults);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) sigaddset(&defaults, signal);
        posix_spawnattr_setsigdefault(&attributes_, &defaults);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
    }
    Spawn(const Spawn&) = delete;
    Spawn& operator=(const Spawn&) = delete;
    ~Spawn() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }

    void open(int descriptor, const std::string& file, int flags) {
        posix_spawn_file_actions_addopen(&actions_, descriptor, file.c_str(), flags, 0600);
    }
    void close(int descriptor) { posix_spawn_file_actions_addclose(&actions_, descriptor); }
    void use(int descriptor, int end) { posix_spawn_file_actions_adddup2(&actions_, end, descriptor); }

    pid_t start(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
        std::vector<std::string> words = {NACRE_CLI}, variables = environment;
        words.insert(words.end(), arguments.begin(), arguments.end());
        for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
        pid_t child = 0;
        if (posix_spawn(&child, NACRE_CLI, &actions_, &attributes_, pointers_to(words).data(),
                        pointers_to(variables).data()) != 0)
            throw std::runtime_error("nacre-cli does not start");
        return child;
    }

  private:
    static std::vector<char*> pointers_to(std::vector<std::string>& texts) {
        std::vector<char*> pointers;
        for (std::string& text : texts) pointers.push_back(text.data());
        pointers.push_back(nullptr);
        return pointers;
    }

    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

// What comes until the other end is closed, by a reader that takes its time.
std::string read_slowly(int descriptor) {
    std::string text;
    char bytes[30'000];
    for (ssize_t count = 1; count > 0;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        count = ::read(descriptor, bytes, sizeof bytes);
        if (count > 0) text.append(bytes, static_cast<std::size_t>(count));
    }
    return text;
}

}  // namespace

Finished run_cli(const std::vector<std::string>& arguments, const ChildOptions& options) {
    const TemporaryFolder folder;
    write_all(folder / "in", options.input);
    Pipe input, output;
    Spawn spawn;
    if (options.input_stays_open) {
        spawn.use(STDIN_FILENO, input.ends[0]);
        if (::write(input.ends[1], options.input.data(), options.input.size()) < 0)
            throw std::runtime_error("pipe");
    } else {
        spawn.open(STDIN_FILENO, options.input_from.empty() ? (folder / "in").string() : options.input_from,
                   O_RDONLY);
    }
    const std::string out = options.output_to.empty() ? (folder / "out").string() : options.output_to;
    if (options.output_reader_gone || options.output_slow) {
        spawn.use(STDOUT_FILENO, output.ends[1]);
        if (options.output_reader_gone) output.close_end(0);
        if (options.output_slow) ::fcntl(output.ends[1], F_SETFL, O_NONBLOCK);
    } else {
        spawn.open(STDOUT_FILENO, out, O_CREAT | O_WRONLY);
    }
    const std::string err = options.error_to.empty() ? (folder / "err").string() : options.error_to;
    spawn.open(STDERR_FILENO, err, O_CREAT | O_WRONLY);
    for (const int descriptor : options.closed) spawn.close(descriptor);
    const pid_t child = [&] {
        std::optional<FileSizeLimit> limit;
        if (options.file_bytes_max >= 0) limit.emplace(static_cast<rlim_t>(options.file_bytes_max));
        return spawn.start(arguments, options.environment);
    }();
    Finished finished;
    if (options.output_slow) {
        output.close_end(1);
        finished.out = read_slowly(output.ends[0]);
    }
    if (options.signal != 0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(options.signal_after));
        ::kill(child, options.signal);
    }
    const Clock::time_point signalled = Clock::now();
    int status = 0;
    ::waitpid(child, &status, 0);
    finished.seconds_after_signal = std::chrono::duration<double>(Clock::now() - signalled).count();
    finished.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (options.output_to.empty() && !options.output_slow) finished.out = read_all(folder / "out");
    if (options.error_to.empty()) finished.err = read_all(folder / "err");
    return finished;
}

std::string answer(const std::vector<std::string>& arguments, std::string_view input) {
    const Finished finished = run_cli(arguments, {.input = std::string(input)});
    CHECK(finished.err == "");
    REQUIRE(finished.code == 0);
    return finished.out;
}

std::vector<std::vector<double>> rows(const std::string& text) {
    std::vector<std::vector<double>> result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<double>& row = result.emplace_back();
        const char* at = line.c_str();
        for (char* end = nullptr;; at = end) {
            const double value = std::strtod(at, &end);
            if (end == at) break;
            row.push_back(value);
        }
    }
    return result;
}

bool is_one_line_with(const std::string& what, const std::vector<std::string>& parts) {
    if (!what.starts_with("nacre-cli: ") || what.find('\n') != what.size() - 1) return false;
    std::size_t at = 0;
    for (const std::string& part : parts) {
        at = what.find(part, at);
        if (at == std::string::npos) return false;
        at += part.size();
    }
    return true;
}

}  // namespace nacre::test
