// Errors of the user: a file that is wrong, or that cannot be read or written. Programming
// mistakes are asserts, never these.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace nacre {

// what() is the one line that every program prints: `FILE: WHERE: what is wrong (what was found)`.
struct UserError : std::runtime_error {
    UserError(std::string in_file, std::string at, std::string wrong, std::string seen = {});

    std::string file;
    std::string where;    // a key's path, `line L, column C`, or the step that failed: open, read, write
    std::string problem;  // what is wrong, and what would be right
    std::string found;    // may be empty
};

// The message of what was thrown, for output that names the file already: a UserError's without the
// file, else what().
std::string plain_words(const std::exception_ptr& error);

// The message of what was thrown, in one line: what(), except for exceptions of the standard library.
std::string problem_line(const std::exception_ptr& error = std::current_exception());

// The text on one line of printable UTF-8: control characters and bytes that are not UTF-8 become
// escapes, and what is longer than `length_max` characters ends in "...".
std::string one_line(std::string_view text, std::size_t length_max = std::string_view::npos);

}  // namespace nacre
