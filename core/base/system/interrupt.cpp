#include "core/base/system/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <utility>

#include "core/base/system/standard_streams.h"

namespace nacre {
namespace {

using namespace std::chrono_literals;

constexpr auto grace = 200ms;
constexpr timespec between_looks{.tv_sec = 0, .tv_nsec = 50'000'000};

// A signal that was ignored when the program began (nohup, a shell's background job) stays so.
bool ignored(int signal) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    return now.sa_handler == SIG_IGN;
}

}  // namespace

Interrupt::Interrupt(std::string last_words) : last_words_(std::move(last_words)) {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!ignored(signal)) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    watcher_ = std::jthread([this](const std::stop_token& closing) { watch(closing); });
}

Interrupt::~Interrupt() {
    watcher_.request_stop();
    watcher_.join();
    pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
}

void Interrupt::watch(const std::stop_token& closing) {
    while (sigtimedwait(&signals_, nullptr, &between_looks) < 0)
        if (closing.stop_requested()) return;
    source_.request_stop();
    const auto end = std::chrono::steady_clock::now() + grace;
    while (std::chrono::steady_clock::now() < end) {
        if (closing.stop_requested()) return;
        std::this_thread::sleep_for(10ms);
    }
    const std::lock_guard lock(writing_);
    if (closing.stop_requested()) return;
    write_message(last_words_, grace);
    ::_exit(1);
}

void Interrupt::write_files(const std::function<void()>& write) {
    const std::lock_guard lock(writing_);
    check();
    write();
}

}  // namespace nacre
