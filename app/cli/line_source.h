// Lines of standard input, as they come.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/system/interrupt.h"

namespace nacre::cli {

struct InputLine {
    std::size_t number;     // from 1
    std::string_view text;  // without its end
};

class LineSource {
  public:
    explicit LineSource(const Interrupt& interrupt);

    // Up to `count` further lines, as soon as there is one; none at the end. Valid until the next call.
    const std::vector<InputLine>& next(std::size_t count);

    // The part of the input that has been handed out, in [0, 1]; 0 where its size is not known.
    double done() const;

  private:
    bool read_more();
    void check_length(std::string_view text) const;

    const Interrupt& interrupt_;
    std::string buffer_;
    std::size_t begin_ = 0;  // of what has not been handed out
    std::size_t number_ = 0;
    bool ended_ = false;
    std::vector<InputLine> lines_;
    double size_ = 0;   // bytes, of a regular file
    double taken_ = 0;  // bytes
};

}  // namespace nacre::cli
