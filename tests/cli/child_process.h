// nacre-cli as a child process.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre::test {

struct Finished {
    int code = -1;  // exit code; 128 + signal when a signal ended it
    std::string out;
    std::string err;
    double seconds_after_signal = 0;  // from `signal` to the end
};

struct ChildOptions {
    std::string input = {};                     // on standard input
    std::string input_from = {};                // a file that is standard input in place of `input`
    bool input_stays_open = false;              // a pipe that brings `input` and then nothing
    std::string output_to = {};                 // a file or device in place of a captured output
    std::string error_to = {};                  // the same of standard error
    std::vector<int> closed = {};               // descriptors that are not open when it begins
    std::vector<std::string> environment = {};  // NAME=VALUE, beside what there is
    bool output_reader_gone = false;
    bool output_slow = false;   // a pipe that does not wait, read from little by little
    long file_bytes_max = -1;   // how far a file may grow (RLIMIT_FSIZE); as far as it will below 0
    int signal = 0;             // sent after `signal_after`
    double signal_after = 0.5;  // seconds
};

Finished run_cli(const std::vector<std::string>& arguments, const ChildOptions& options = {});

// Runs it, requires exit code 0 and silence on standard error, and returns the output.
std::string answer(const std::vector<std::string>& arguments, std::string_view input = {});

// The numbers of each line.
std::vector<std::vector<double>> rows(const std::string& text);

// `what` is one line that begins with `nacre-cli: ` and holds each of the parts in order.
bool is_one_line_with(const std::string& what, const std::vector<std::string>& parts);

}  // namespace nacre::test
