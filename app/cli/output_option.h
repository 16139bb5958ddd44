// Where what a verb makes goes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/cli/command.h"

namespace nacre::cli {

struct OutputOption {
    std::string file;    // "-": standard output
    std::string format;  // of standard output, empty for the first there is

    // A name whose extension tells the format.
    std::string named() const;
    // What is to be checked against the inputs.
    std::vector<std::filesystem::path> outputs() const;

    std::vector<std::string> formats;
};

// -o and, where there is a choice, --format. `about` tells what kinds of file there are.
void add_output_option(Command& command, OutputOption& output, const std::vector<std::string>& formats,
                       const std::string& about);

// Wrong usage where --format is given of a file, whose name tells it.
void check_usage(const OutputOption& output);

// -o of a verb that fills a folder.
Option add_folder_option(Command& command, std::string& folder, const std::string& about);

// What is wrong with an empty name, or nothing.
std::string not_empty(const std::string& name);

// A check of an option that cannot be "-" nor empty.
std::function<std::string(const std::string&)> no_stream(const std::string& why);

}  // namespace nacre::cli
