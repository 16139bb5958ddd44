#include "core/exchange/export_format.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/exchange/atomic_file.h"
#include "core/exchange/glsl_export.h"
#include "core/exchange/table_files.h"
#include "core/measure/reference.h"
#include "core/measure/table_error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

using Progress = std::function<void(double)>;

constexpr std::size_t prefix_most = 64;  // characters

ExportWriter prepare_exr(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                         const Progress& progress) {
    BakeOptions options = settings.bake;
    options.albedo = true;
    const auto tables = bake(design, options, stop, progress);
    const TableErrors errors = measure_table_errors(*tables, Reference(design), stop);
    return ExportWriter([design, tables, errors](const fs::path& folder) {
        write_table_files(folder, design, *tables, errors);
    });
}

ExportWriter prepare_glsl(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                          const Progress& progress) {
    return ExportWriter(glsl_export(design, *bake(design, settings.bake, stop, progress), settings.prefix));
}

std::vector<fs::path> exr_files(const Design& design, const fs::path& folder) {
    return table_files(folder, design);
}

std::vector<fs::path> one_file(const Design&, const fs::path& file) { return {file}; }

constexpr ExportFormat formats[] = {
    {"exr", "Tables as EXR pictures", "a folder of tables as EXR pictures, with manifest.json", "", false,
     exr_files, prepare_exr},
    {"glsl", "GLSL function", "one file with the function {prefix}_brdf(k1, k2) and its tables as constants",
     ".glsl", true, one_file, prepare_glsl},
};

}  // namespace

void ExportWriter::operator()(const fs::path& output) const {
    if (fill_)
        fill_(output);
    else
        write_file_atomically(output, bytes_);
}

std::span<const ExportFormat> export_formats() { return formats; }

std::string about(const ExportFormat& format, std::string_view prefix) {
    return fmt::format(fmt::runtime(format.about), fmt::arg("prefix", prefix));
}

std::string prefix_problem(std::string_view prefix) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    const bool sound = !prefix.empty() && prefix.size() <= prefix_most && letter(prefix.front()) &&
                       std::all_of(prefix.begin(), prefix.end(), allowed);
    if (!sound)
        return fmt::format("must be 1 to {} letters a to z, digits and underscores, a letter first",
                           prefix_most);
    // GLSL keeps these for itself (GLSL 3.30, 3.7); the underscore that joins prefix and name counts too.
    if (prefix.starts_with("gl_") || prefix == "gl") return "must not begin with gl_";
    if (prefix.find("__") != prefix.npos || prefix.back() == '_')
        return "must hold no two underscores in a row and end in none: one is put after it";
    return {};
}

const ExportFormat* export_format(std::string_view name) {
    const auto found = std::find_if(std::begin(formats), std::end(formats),
                                    [&](const ExportFormat& format) { return format.name == name; });
    return found == std::end(formats) ? nullptr : found;
}

}  // namespace nacre
