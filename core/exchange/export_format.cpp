#include "core/exchange/export_format.h"

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

ExportWriter prepare_exr(const Design& design, BakeOptions options, const std::stop_token& stop,
                         const Progress& progress) {
    options.albedo = true;
    const auto tables = bake(design, options, stop, progress);
    const TableErrors errors = measure_table_errors(*tables, Reference(design), stop);
    return ExportWriter([design, tables, errors](const fs::path& folder) {
        write_table_files(folder, design, *tables, errors);
    });
}

ExportWriter prepare_glsl(const Design& design, BakeOptions options, const std::stop_token& stop,
                          const Progress& progress) {
    return ExportWriter(glsl_export(design, *bake(design, options, stop, progress)));
}

std::vector<fs::path> exr_files(const Design& design, const fs::path& folder) {
    return table_files(folder, design);
}

std::vector<fs::path> one_file(const Design&, const fs::path& file) { return {file}; }

constexpr ExportFormat formats[] = {
    {"exr", "Tables as EXR pictures", "a folder of tables as EXR pictures, with manifest.json", "", exr_files,
     prepare_exr},
    {"glsl", "GLSL function", "one file with the function nacre_brdf(k1, k2) and its tables as constants",
     ".glsl", one_file, prepare_glsl},
};

}  // namespace

void ExportWriter::operator()(const fs::path& output) const {
    if (fill_)
        fill_(output);
    else
        write_file_atomically(output, bytes_);
}

std::span<const ExportFormat> export_formats() { return formats; }

const ExportFormat* export_format(std::string_view name) {
    const auto found = std::find_if(std::begin(formats), std::end(formats),
                                    [&](const ExportFormat& format) { return format.name == name; });
    return found == std::end(formats) ? nullptr : found;
}

}  // namespace nacre
