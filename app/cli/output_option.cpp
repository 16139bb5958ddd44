#include "app/cli/output_option.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/output.h"

namespace nacre::cli {

std::string not_empty(const std::string& name) { return name.empty() ? "has no value" : ""; }

std::string OutputOption::named() const {
    return file == stream_name ? "-." + (format.empty() ? formats.front() : format) : file;
}

std::vector<std::filesystem::path> OutputOption::outputs() const {
    return {file == stream_name ? "/dev/stdout" : file};
}

void add_output_option(Command& command, OutputOption& output, const std::vector<std::string>& formats,
                       const std::string& about) {
    output.formats = formats;
    command.option("-o,--output", output.file, about + "; - is standard output").required().check(not_empty);
    if (formats.size() == 1) return;
    command
        .option("--format", output.format,
                fmt::format("of -o -: {} (default {})", fmt::join(formats, " or "), formats.front()))
        .one_of(formats);
}

void check_usage(const OutputOption& output) {
    if (!output.format.empty() && output.file != stream_name)
        throw_wrong_usage("--format is for -o -; a file's name tells its format");
}

Option add_folder_option(Command& command, std::string& folder, const std::string& about) {
    return command.option("-o,--output", folder, about).required().check(no_stream("must be a folder"));
}

std::function<std::string(const std::string&)> no_stream(const std::string& why) {
    return [why](const std::string& name) { return name == stream_name ? why + ", not -" : not_empty(name); };
}

}  // namespace nacre::cli
