// What a design can be written as for other programs: one file for each, core/formats/NAME.cpp, and its line
// in format_list.inc, which the command line and the designer read.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bake/bake.h"
#include "core/design/design.h"
#include "core/formats/design_features.h"

namespace nacre {

// The composed files, not yet written.
class ExportWriter {
  public:
    explicit ExportWriter(std::string bytes) : bytes_(std::move(bytes)) {}
    explicit ExportWriter(
        std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> fill)
        : fill_(std::move(fill)) {}

    // Each file appears whole or not at all; what fails is a UserError about it. Returns the files.
    std::vector<std::filesystem::path> operator()(const std::filesystem::path& output) const;

    // Whether it is one file, whose bytes() can go into a stream.
    bool is_one_file() const { return !fill_; }
    const std::string& bytes() const { return bytes_; }

    // What whoever exports should know of this design in this format: a sentence each.
    std::vector<std::string> notes;

  private:
    std::string bytes_;
    // Of a format that is several files.
    std::function<std::vector<std::filesystem::path>(const std::filesystem::path& output)> fill_;
};

struct ExportSettings {
    BakeOptions bake = {};
    std::string prefix = "nacre";  // of every name that a file in a shading language defines
    double error = 0.01;           // the part of the light that a format of limited resolution may misplace
};

// Of an export: one step a line. It has no default, so that no format leaves it out.
class NextSteps {
  public:
    constexpr NextSteps(std::string_view text) : text_(text) {}
    constexpr NextSteps(const char* text) : text_(text) {}
    constexpr std::string_view text() const { return text_; }

  private:
    std::string_view text_;
};

struct ExportFormat {
    std::string_view name;       // as `nacre-cli export --to` takes it
    std::string_view title;      // as a menu shows it
    std::string_view about;      // one line; see about()
    NextSteps next;              // what to do with it in the program that it is for; see next_steps()
    std::string_view extension;  // of its file; empty: it is a folder
    bool has_names;              // it defines names, which begin with ExportSettings::prefix
    bool has_error;              // its size follows ExportSettings::error
    Holdings holds;              // how it has what designs have
    // Every file that it may write.
    std::vector<std::filesystem::path> (*files)(const Design& design, const std::filesystem::path& output);
    // Bakes, measures and composes what writes it; see prepare_export().
    ExportWriter (*prepare)(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                            const std::function<void(double)>& progress);
};

std::span<const ExportFormat* const> export_formats();

#define FORMAT(name) extern const ExportFormat name##_format;
#include "core/formats/format_list.inc"
#undef FORMAT

// How a format has what a design has, for whoever chooses one.
struct DesignHolding {
    bool refused;
    std::string text;  // sentences
};
DesignHolding holding_of(const ExportFormat& format, const Design& design);

// Bakes, measures and composes what writes the design in this format. A UserError where the design has what
// the format refuses; throws what bake() throws.
ExportWriter prepare_export(const ExportFormat& format, const Design& design, const ExportSettings& settings,
                            const std::stop_token& stop, const std::function<void(double)>& progress);

// The formats as JSON: names, texts, options with their defaults, and what each holds.
std::string formats_json();

// `files` of a format that is one file.
std::vector<std::filesystem::path> one_file(const Design& design, const std::filesystem::path& file);

// What a format is, with the names that it defines under this prefix.
std::string about(const ExportFormat& format, std::string_view prefix);

// What to do next with what was written there, step by step.
std::vector<std::string> next_steps(const ExportFormat& format, std::string_view prefix,
                                    const std::filesystem::path& output);
// The same of other steps: {prefix} and {file} stand for what they name.
std::vector<std::string> next_steps(NextSteps next, std::string_view prefix,
                                    const std::filesystem::path& output);

// What is wrong with a prefix of names, or nothing: letters, digits and single underscores, a letter first.
std::string prefix_problem(std::string_view prefix);

// Null for an unknown name.
const ExportFormat* export_format(std::string_view name);

}  // namespace nacre
