#include "core/formats/export_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/system/atomic_file.h"
#include "core/base/utf8.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t prefix_max = 64;      // characters
constexpr std::size_t file_name_max = 120;  // of it, in a step

}  // namespace

std::vector<fs::path> ExportWriter::operator()(const fs::path& output) const {
    if (fill_) return fill_(output);
    write_file_atomically(output, bytes_);
    return {output};
}

std::span<const ExportFormat* const> export_formats() {
    static const std::array formats{
#define FORMAT(name) &name##_format,
#include "core/formats/format_list.inc"
#undef FORMAT
    };
    return formats;
}

std::vector<fs::path> one_file(const Design&, const fs::path& file) { return {file}; }

std::string about(const ExportFormat& format, std::string_view prefix) {
    return fmt::format(fmt::runtime(format.about), fmt::arg("prefix", prefix));
}

std::vector<std::string> next_steps(NextSteps next, std::string_view prefix, const fs::path& output) {
    const fs::path whole = output.has_filename() ? output : output.parent_path();
    const std::string text =
        fmt::format(fmt::runtime(next.text()), fmt::arg("prefix", prefix),
                    fmt::arg("file", one_line(as_utf8(whole.filename().string()), file_name_max)));
    std::vector<std::string> steps(1);
    for (const char c : text)
        if (c == '\n')
            steps.emplace_back();
        else
            steps.back() += c;
    return steps;
}

std::vector<std::string> next_steps(const ExportFormat& format, std::string_view prefix,
                                    const fs::path& output) {
    return next_steps(format.next, prefix, output);
}

std::string prefix_problem(std::string_view prefix) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    const bool sound = !prefix.empty() && prefix.size() <= prefix_max && letter(prefix.front()) &&
                       std::all_of(prefix.begin(), prefix.end(), allowed);
    if (!sound)
        return fmt::format("must be 1 to {} letters a to z, digits and underscores, a letter first",
                           prefix_max);
    // GLSL keeps these for itself (GLSL 3.30, 3.7); the underscore that joins prefix and name counts too.
    if (prefix.starts_with("gl_") || prefix == "gl") return "must not begin with gl_";
    if (prefix.find("__") != prefix.npos || prefix.back() == '_')
        return "must hold no two underscores in a row and end in none: one is put after it";
    return {};
}

const ExportFormat* export_format(std::string_view name) {
    for (const ExportFormat* format : export_formats())
        if (format->name == name) return format;
    return nullptr;
}

}  // namespace nacre
