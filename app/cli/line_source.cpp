#include "app/cli/line_source.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/system/standard_streams.h"

namespace nacre::cli {
namespace {

constexpr std::size_t block_min = 1u << 16, block_max = 4u << 20;  // bytes that are read at once
constexpr std::size_t line_max = 1u << 16;  // bytes: an input without ends of lines cannot fill the memory
constexpr std::chrono::milliseconds between_looks{50};  // at Ctrl+C

}  // namespace

LineSource::LineSource(const Interrupt& interrupt)
    : interrupt_(interrupt), size_(static_cast<double>(input_size().value_or(0))) {}

double LineSource::done() const { return size_ > 0 ? std::min(taken_ / size_, 1.0) : 0; }

bool LineSource::read_more() {
    do interrupt_.check();
    while (!input_is_ready(between_looks));
    buffer_.erase(0, begin_);
    begin_ = 0;
    // As much again as has come so far: a short input takes little memory.
    const std::size_t kept = buffer_.size();
    const std::size_t block = std::clamp(static_cast<std::size_t>(taken_) + kept, block_min, block_max);
    buffer_.resize(kept + block);
    const auto count = read_input(buffer_.data() + kept, block);
    buffer_.resize(kept + count.value_or(0));
    return count != 0;
}

void LineSource::check_length(std::string_view text) const {
    if (text.size() > line_max)
        throw UserError(standard_input, fmt::format("line {}", number_ + 1),
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
