// The statements of a Wavefront OBJ file, word by word.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace nacre {

struct ObjWord {
    std::string_view text;
    std::size_t line = 1;  // of the file, from 1 on
};

// Gives out one statement after the other. A line ends with LF, CR LF or CR; a backslash at its end continues
// the statement on the next one. A # begins a comment, which ends with its line and
// continues on no other.
class ObjLines {
  public:
    explicit ObjLines(std::string_view text) : rest_(text) {}

    // The words of the next statement that has any, the keyword first. False at the end. They are parts of
    // the text.
    bool next(std::vector<ObjWord>& words);

  private:
    std::string_view take_line();
    static bool add_words(std::string_view line, std::size_t number, std::vector<ObjWord>& words);

    std::string_view rest_;
    std::size_t line_ = 0;  // that was taken last
};

// "UTF-16" or "UTF-32" where the text is no sequence of bytes but of wider units; else empty.
std::string_view wide_encoding(std::string_view text);

}  // namespace nacre
