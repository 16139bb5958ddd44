// Standard input, output and error, and what a program does about them before anything else.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace nacre {

// A standard descriptor that was closed is taken up, so that no file opened later gets its number and what is
// said there; reading and writing it fails. Where a write cannot be done (the reader has gone, the file may
// not grow) it says so in place of ending the program.
void prepare_streams();

// As errors call it.
inline constexpr const char* standard_input = "standard input";

// Whether something can be read, or its end is reached; waits for that as long as `patience`, and less where
// a signal comes.
bool input_is_ready(std::chrono::milliseconds patience);
void wait_for_input();

// Up to `length` bytes: 0 at the end, nothing where none has come yet. An error is a UserError of `standard
// input`.
std::optional<std::size_t> read_input(char* to, std::size_t length);

// Bytes; nothing where it is no regular file.
std::optional<std::uintmax_t> input_size();

// Whoever read the output has gone.
struct ReaderGone : std::runtime_error {
    ReaderGone() : std::runtime_error("nobody reads the output") {}
};

// Writes through to standard output; a failure is a UserError of `standard output`, or ReaderGone.
void write_output(std::string_view text);

// To standard error; what cannot be written within the time is lost.
void write_message(std::string_view text, std::chrono::milliseconds patience);

bool output_is_terminal();
bool error_is_terminal();

}  // namespace nacre
