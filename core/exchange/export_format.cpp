#include "core/exchange/export_format.h"

#include <algorithm>

#include "core/exchange/atomic_file.h"
#include "core/exchange/glsl_export.h"
#include "core/exchange/table_files.h"
#include "core/measure/reference.h"
#include "core/measure/table_error.h"

namespace nacre {
namespace {

using Progress = std::function<void(double)>;

ExportWriter prepare_exr(const Design& design, BakeOptions options, const std::stop_token& stop,
                         const Progress& progress) {
    options.albedo = true;
    const auto tables = bake(design, options, stop, progress);
    const TableErrors errors = measure_table_errors(*tables, Reference(design), stop);
    return [design, tables, errors](const std::filesystem::path& folder) {
        write_table_files(folder, design, *tables, errors);
    };
}

ExportWriter prepare_glsl(const Design& design, BakeOptions options, const std::stop_token& stop,
                          const Progress& progress) {
    return [text = glsl_export(design, *bake(design, options, stop, progress))](
               const std::filesystem::path& file) { write_file_atomically(file, text); };
}

constexpr ExportFormat formats[] = {
    {"exr", "Tables as EXR pictures", "a folder of tables as EXR pictures, with manifest.json", "",
     prepare_exr},
    {"glsl", "GLSL function", "one file with the function nacre_brdf(k1, k2) and its tables as constants",
     ".glsl", prepare_glsl},
};

}  // namespace

std::span<const ExportFormat> export_formats() { return formats; }

const ExportFormat* export_format(std::string_view name) {
    const auto found = std::find_if(std::begin(formats), std::end(formats),
                                    [&](const ExportFormat& format) { return format.name == name; });
    return found == std::end(formats) ? nullptr : found;
}

}  // namespace nacre
