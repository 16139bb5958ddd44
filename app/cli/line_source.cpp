#include "app/cli/line_source.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/design/error.h"
#include "core/exchange/input_file.h"

namespace nacre::cli {
namespace {

constexpr std::size_t block = 4u << 20;     // bytes that are read at once, if they are there
constexpr std::size_t line_max = 1u << 16;  // bytes: an input without ends of lines cannot fill the memory
constexpr int look_milliseconds = 50;       // between looks at Ctrl+C

}  // namespace

LineSource::LineSource(const Interrupt& interrupt) : interrupt_(interrupt) {
    struct stat status {};
    if (::fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode))
        size_ = static_cast<double>(status.st_size);
}

double LineSource::done() const { return size_ > 0 ? std::min(taken_ / size_, 1.0) : 0; }

bool LineSource::read_more() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    for (int ready = 0; ready == 0 || (ready < 0 && errno == EINTR);) {
        interrupt_.check();
        ready = ::poll(&input, 1, look_milliseconds);
    }
    buffer_.erase(0, begin_);
    begin_ = 0;
    const std::size_t kept = buffer_.size();
    buffer_.resize(kept + block);
    const ssize_t count = ::read(STDIN_FILENO, buffer_.data() + kept, block);
    const int error = errno;
    buffer_.resize(kept + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && error != EINTR && error != EAGAIN)
        throw UserError("standard input", "read", "it cannot be read",
                        std::generic_category().message(error));
    return count != 0;
}

void LineSource::check_length(std::string_view text) const {
    if (text.size() > line_max)
        throw UserError("standard input", fmt::format("line {}", number_ + 1),
                        fmt::format("longer than {} bytes", line_max), one_line(text.substr(0, 40)) + "...");
}

const std::vector<InputLine>& LineSource::next(std::size_t count) {
    lines_.clear();
    while (!ended_ && buffer_.find('\n', begin_) == std::string::npos) {
        check_length(std::string_view(buffer_).substr(begin_));
        ended_ = !read_more();
    }
    const std::string_view all = buffer_;
    const std::size_t before = begin_;
    while (lines_.size() < count && begin_ < all.size()) {
        const std::size_t end = all.find('\n', begin_);
        if (end == std::string_view::npos && !ended_) break;
        std::string_view text = all.substr(begin_, end == std::string_view::npos ? end : end - begin_);
        check_length(text);
        begin_ = end == std::string_view::npos ? all.size() : end + 1;
        if (text.ends_with('\r')) text.remove_suffix(1);
        if (number_ == 0) text = without_byte_order_mark(text);
        lines_.push_back({++number_, text});
    }
    taken_ += static_cast<double>(begin_ - before);
    return lines_;
}

}  // namespace nacre::cli
